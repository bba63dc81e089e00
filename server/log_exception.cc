#include "server/log_exception.h"

#include <exception>
#include <string>

#include "server/logging/log_limiter.h"

namespace fovea::server {

void LogCurrentException(const char* what) noexcept {
  try {
    try {
      throw;
    } catch (const std::exception& error) {
      LogLimited(what, spdlog::level::err, std::string(what) + ": " + error.what());
    } catch (...) {
      LogLimited(what, spdlog::level::err, std::string(what) + ": an exception of unknown type");
    }
  } catch (...) {  // NOLINT(bugprone-empty-catch): there is nobody left to tell
  }
}

}  // namespace fovea::server
