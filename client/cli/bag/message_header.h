#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "client/cli/bag/cdr_reader.h"

namespace fovea::cli {

// What images and camera_info begin with.
struct Header {
  std::int64_t stamp_ns = 0;  // 0 where none was set
  std::string frame;          // the coordinate frame that it is of
};

inline Header ReadHeader(CdrReader& reader) {
  constexpr std::int64_t kNsPerSecond = 1'000'000'000;
  const std::int64_t seconds = reader.Number<std::int32_t>();
  const std::int64_t nanoseconds = reader.Number<std::uint32_t>();
  return {seconds * kNsPerSecond + nanoseconds, std::string(reader.Text())};
}

// Throws std::invalid_argument where the message is none such.
inline Header HeaderOf(std::string_view message) {
  CdrReader reader(message);
  return ReadHeader(reader);
}

}  // namespace fovea::cli
