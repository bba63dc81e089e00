#pragma once

#include <optional>
#include <string>

#include "fovea/v1/frame.pb.h"

namespace fovea::bundle {

struct ImageFile {
  std::string ending;  // ".png"
  std::string bytes;
};

// Files that any program reads; the same bytes where such a file was sent. None where the image is
// not what it says it is, as that of a frame that was refused.
std::optional<ImageFile> ColorFile(const v1::ColorImage& color);
// 16 bits, in units of UnitOf().
std::optional<ImageFile> DepthFile(const v1::DepthImage& depth);

// Metres per unit of such a file; depth that was sent as metres is in millimetres there.
double UnitOf(const v1::DepthImage& depth);

}  // namespace fovea::bundle
