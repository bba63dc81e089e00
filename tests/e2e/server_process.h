#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/e2e/process.h"

namespace fovea::testing {

// fovea-server on a free port.
class ServerProcess {
 public:
  explicit ServerProcess(std::vector<std::string> flags = {})
      : process_(CommandLine(std::move(flags))), line_(process_.ReadLine()) {}

  // What it printed when it was ready.
  const std::string& line() const { return line_; }
  std::string address() const { return line_.substr(line_.rfind(' ') + 1); }
  Process& process() { return process_; }

 private:
  static std::vector<std::string> CommandLine(std::vector<std::string> flags) {
    flags.insert(flags.begin(), {FOVEA_SERVER, "--listen", "127.0.0.1:0"});
    return flags;
  }

  Process process_;
  std::string line_;
};

}  // namespace fovea::testing
