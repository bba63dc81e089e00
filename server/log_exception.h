#pragma once

namespace fovea::server {

// Call it inside a catch block where the exception must go no further: one line in the log, of what
// could not be done.
void LogCurrentException(const char* what) noexcept;

// Calls `step`; what it throws goes no further.
template <typename Step>
void CallOrLog(const char* what, Step&& step) noexcept {
  try {
    step();
  } catch (...) {
    LogCurrentException(what);
  }
}

}  // namespace fovea::server
