#include "server/log_exception.h"

#include <spdlog/spdlog.h>

#include <exception>

namespace fovea::server {

void LogCurrentException(const char* what) noexcept {
  try {
    try {
      throw;
    } catch (const std::exception& error) {
      spdlog::error("{}: {}", what, error.what());
    } catch (...) {
      spdlog::error("{}: an exception of unknown type", what);
    }
  } catch (...) {  // NOLINT(bugprone-empty-catch): there is nobody left to tell
  }
}

}  // namespace fovea::server
