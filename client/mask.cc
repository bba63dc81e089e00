#include "client/mask.h"

#include <numeric>
#include <stdexcept>
#include <string>

namespace fovea::client {

std::vector<std::uint8_t> DecodeMask(const v1::Mask& mask) {
  if (mask.runs().empty()) {
    throw std::invalid_argument("there is no mask: DetectOptions.return_masks asks for it");
  }
  const std::uint64_t num_pixels = std::uint64_t{mask.bounds().width()} * mask.bounds().height();
  const std::uint64_t sum =
      std::accumulate(mask.runs().begin(), mask.runs().end(), std::uint64_t{0});
  if (sum != num_pixels) {
    throw std::invalid_argument("the mask's runs cover " + std::to_string(sum) + " pixels, not " +
                                std::to_string(num_pixels));
  }
  std::vector<std::uint8_t> pixels;
  pixels.reserve(num_pixels);
  std::uint8_t value = 0;
  for (const std::uint32_t run : mask.runs()) {
    pixels.insert(pixels.end(), run, value);
    value ^= 1;
  }
  return pixels;
}

}  // namespace fovea::client
