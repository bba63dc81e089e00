// The log of the whole process.
#pragma once

#include <string>
#include <thread>

#include "server/logging/log_format.h"

namespace fovea::server {

// Log lines of this process, of gRPC and of protobuf go to stderr as long as this lives, and later
// too, but then nobody says any more how many were left out.
class Logging {
 public:
  // `level`: trace, debug, info, warn, error or off.
  Logging(const std::string& level, LogFormat format);
  ~Logging();

  Logging(const Logging&) = delete;
  Logging& operator=(const Logging&) = delete;

  static void SetLevel(const std::string& level);

 private:
  std::jthread summaries_;
};

// Call it first of all. Neither a log nor an output whose reader has gone ends the process
// (SIGPIPE), nor a file that may not grow any more (SIGXFSZ), and no connection gets the number of
// a standard stream that was closed, and with it what is meant for that.
void GuardStandardStreams();

// To stdout; where nobody takes it, it is dropped.
void Announce(const std::string& line);

}  // namespace fovea::server
