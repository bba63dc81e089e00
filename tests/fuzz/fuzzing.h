// What all fuzzers share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>

namespace fovea::fuzzing {

// Small, so that most of the time goes into finding new paths, not into decoding large images.
constexpr std::uint64_t kMaxPixels = 64 * 64;

inline std::string_view Text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

// Bad input must end in std::invalid_argument and in nothing else.
template <typename Function>
void Try(Function&& function) {
  try {
    function();
  } catch (const std::invalid_argument&) {  // NOLINT(bugprone-empty-catch): the refusal wanted
  }
}

}  // namespace fovea::fuzzing
