#include "client/cli/camera_window.h"

#include <algorithm>
#include <stdexcept>

namespace fovea::cli {
namespace {

// One axis of a camera; 0 pixels = not said.
void ApplyToAxis(std::uint32_t offset, std::uint32_t cut, std::uint32_t binning, double* focal,
                 double* center, int* pixels) {
  const std::uint32_t whole = *pixels > 0 ? static_cast<std::uint32_t>(*pixels) : 0;
  if (whole > 0 && std::uint64_t{offset} + cut > whole) {
    throw std::invalid_argument("its roi is not within its width and height");
  }
  const std::uint32_t bin = std::max(1U, binning);
  if (whole > 0 && bin > (cut > 0 ? cut : whole)) {
    throw std::invalid_argument("its binning leaves no pixel");
  }
  *focal /= bin;
  *center = (*center - offset) / bin;
  if (whole > 0) *pixels = static_cast<int>((cut > 0 ? cut : whole) / bin);
}

}  // namespace

void Apply(const CameraWindow& window, Calibration* calibration) {
  Calibration& c = *calibration;
  ApplyToAxis(window.x_offset, window.width, window.binning_x, &c.fx, &c.cx, &c.width);
  ApplyToAxis(window.y_offset, window.height, window.binning_y, &c.fy, &c.cy, &c.height);
}

}  // namespace fovea::cli
