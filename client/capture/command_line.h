// The subcommands of `fovea-capture`.
#pragma once

namespace fovea::capture {

// The main function: its exit code.
int RunCommandLine(int argc, char** argv);

}  // namespace fovea::capture
