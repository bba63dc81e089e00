#include "server/codec/size_limits.h"

#include <stdexcept>

namespace fovea::server {

void SizeLimits::Check(std::uint64_t actual_width, std::uint64_t actual_height,
                       const std::string& kind) const {
  const std::string size = SizeText(actual_width, actual_height);
  if (actual_width == 0 || actual_height == 0) {
    throw std::invalid_argument(kind + " is " + size + "; width and height must be positive");
  }
  if (actual_width > max_pixels || actual_height > max_pixels / actual_width) {
    throw std::invalid_argument(kind + " is " + size + ", more than this server's limit of " +
                                std::to_string(max_pixels) + " pixels (--max-pixels)");
  }
  const bool width_differs = width != 0 && width != actual_width;
  const bool height_differs = height != 0 && height != actual_height;
  if (width_differs || height_differs) {
    throw std::invalid_argument(kind + " is " + size + ", but the message says " +
                                SizeText(width, height));
  }
}

std::string SizeText(std::uint64_t width, std::uint64_t height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

}  // namespace fovea::server
