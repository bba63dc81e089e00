// The time of day, as certificates and tokens know it.
#pragma once

#include <chrono>

namespace fovea::server {

inline std::chrono::sys_seconds NowInSeconds() {
  return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
}

}  // namespace fovea::server
