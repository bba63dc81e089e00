// Errors that name the field of the request they are about.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace fovea::server {

// "<path>: <message>"
[[noreturn]] inline void FailField(const std::string& path, const std::string& message) {
  throw std::invalid_argument(path + ": " + message);
}

inline void RequireField(bool holds, const std::string& path, const std::string& message) {
  if (!holds) FailField(path, message);
}

// Calls `function`; puts the path before the text of a std::invalid_argument that it throws.
template <typename Function>
auto InField(const std::string& path, Function&& function) {
  try {
    return std::forward<Function>(function)();
  } catch (const std::invalid_argument& error) {
    FailField(path, error.what());
  }
}

}  // namespace fovea::server
