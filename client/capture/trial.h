// Tries what may end the whole program.
#pragma once

#include <functional>

namespace fovea::capture {

// Whether `function` returns within `patience_s` when a child process runs it, which says nothing.
// For libraries that end the program where something is missing. Call it before threads start.
bool SucceedsInAChild(const std::function<void()>& function, unsigned patience_s);

}  // namespace fovea::capture
