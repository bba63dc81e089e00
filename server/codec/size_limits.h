// What a decoder must hold a file's claimed size against before it allocates anything.
#pragma once

#include <cstdint>
#include <string>

namespace fovea::server {

struct SizeLimits {
  // The size the caller of the service announced; 0 = not announced.
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint64_t max_pixels = 0;

  // Throws std::invalid_argument unless an image of this size is wanted. `kind` starts the text,
  // for example "the PNG".
  void Check(std::uint64_t actual_width, std::uint64_t actual_height,
             const std::string& kind) const;
};

// "640x480".
std::string SizeText(std::uint64_t width, std::uint64_t height);

}  // namespace fovea::server
