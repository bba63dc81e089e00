// Errors that name the field of the request they are about.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace fovea::server {

// What a caller, or who configures, got wrong. A std::invalid_argument that is none was thrown by a
// mistake of ours.
class FieldError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

// "<path>: <message>"
[[noreturn]] inline void FailField(const std::string& path, const std::string& message) {
  throw FieldError(path + ": " + message);
}

inline void RequireField(bool holds, const std::string& path, const std::string& message) {
  if (!holds) FailField(path, message);
}

// Calls `function`, which validates; puts the path before the text of a std::invalid_argument that
// it throws.
template <typename Function>
auto InField(const std::string& path, Function&& function) {
  try {
    return std::forward<Function>(function)();
  } catch (const std::invalid_argument& error) {
    FailField(path, error.what());
  }
}

}  // namespace fovea::server
