#pragma once

#include <string>

#include "tests/e2e/process.h"

namespace fovea::testing {

// fovea-server on a free port.
class ServerProcess {
 public:
  ServerProcess() : process_({FOVEA_SERVER, "--listen", "127.0.0.1:0"}) {
    line_ = process_.ReadLine();
  }

  // What it printed when it was ready.
  const std::string& line() const { return line_; }
  std::string address() const { return line_.substr(line_.rfind(' ') + 1); }
  Process& process() { return process_; }

 private:
  Process process_;
  std::string line_;
};

}  // namespace fovea::testing
