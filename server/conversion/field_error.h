// Errors that name the field of the request they are about.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace fovea::server {

// What a caller, or who configures, got wrong. A std::invalid_argument that is none was thrown by a
// mistake of ours.
class FieldError : public std::invalid_argument {
 public:
  // Its text is "<path>: <message>".
  FieldError(const std::string& path, const std::string& message)
      : std::invalid_argument(path + ": " + message), path_size_(path.size()) {}

  // Both point into the error. Names in brackets come from the caller and may hold anything, so
  // that the text alone does not say where the path ends.
  std::string_view path() const { return std::string_view(what(), path_size_); }
  std::string_view message() const { return what() + path_size_ + 2; }

 private:
  std::size_t path_size_;
};

[[noreturn]] inline void FailField(const std::string& path, const std::string& message) {
  throw FieldError(path, message);
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

// The same where the texts start with the name of an option, "region.x_px: …".
template <typename Function>
auto InParameters(Function&& function) {
  try {
    return std::forward<Function>(function)();
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    const std::size_t end = text.find(": ");
    FailField("options.parameters[" + text.substr(0, end) + "]", text.substr(end + 2));
  }
}

}  // namespace fovea::server
