#include "client/observer/exif.h"

#include <cstddef>
#include <string_view>

namespace fovea::observer {

std::string WithoutExif(std::string jpeg) {
  constexpr std::string_view kStart = "\xFF\xD8", kName("Exif\0\0", 6);
  constexpr unsigned char kMarker = 0xFF, kApp1 = 0xE1, kScan = 0xDA;
  if (!jpeg.starts_with(kStart)) return jpeg;
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(jpeg[at]); };
  std::size_t at = kStart.size();
  // Marker, kind, and the length of what follows, itself included.
  while (at + 4 <= jpeg.size() && byte(at) == kMarker && byte(at + 1) != kScan) {
    const std::size_t length = (std::size_t{byte(at + 2)} << 8U) + byte(at + 3);
    if (byte(at + 1) == kApp1 && jpeg.compare(at + 4, kName.size(), kName) == 0) jpeg[at + 4] = '-';
    at += 2 + length;
  }
  return jpeg;
}

}  // namespace fovea::observer
