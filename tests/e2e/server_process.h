#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tests/e2e/process.h"
#include "tests/support/held_address.h"

namespace fovea::testing {

// fovea-server on a free port, which stays its own: another one may follow it there.
class ServerProcess {
 public:
  explicit ServerProcess(std::vector<std::string> flags = {})
      : process_(CommandLine(address_.Text(), std::move(flags))), line_(process_.ReadLine()) {}

  // What it printed when it was ready.
  const std::string& line() const { return line_; }
  std::string address() const { return line_.substr(line_.rfind(' ') + 1); }
  Process& process() { return process_; }

 private:
  static std::vector<std::string> CommandLine(const std::string& address,
                                              std::vector<std::string> flags) {
    flags.insert(flags.begin(), {FOVEA_SERVER, "--listen", address});
    return flags;
  }

  const HeldAddress address_;
  Process process_;
  std::string line_;
};

}  // namespace fovea::testing
