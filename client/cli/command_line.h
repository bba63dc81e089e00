// The subcommands of `fovea`.
#pragma once

#include <string>

namespace fovea::cli {

// The main function: its exit code.
int RunCommandLine(int argc, char** argv, const std::string& version);

}  // namespace fovea::cli
