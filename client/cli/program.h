// What the command-line programs have in common.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace fovea::cli {

// The main function of a command-line program: parses the flags and calls `run`. Whatever is wrong
// becomes one line on stderr after the program's name, and exit code 1.
int RunProgram(CLI::App& app, int argc, char** argv, const std::function<int()>& run);

}  // namespace fovea::cli
