// fovea-observer: flags → servers to watch → a page over HTTP until a signal comes.
#pragma once

namespace fovea::observer {

// Returns the exit code.
int RunCommandLine(int argc, char** argv);

}  // namespace fovea::observer
