#pragma once

namespace fovea::server {

// Call it inside a catch block where the exception must go no further: one line in the log, of what
// could not be done.
void LogCurrentException(const char* what) noexcept;

}  // namespace fovea::server
