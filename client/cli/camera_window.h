#pragma once

#include <cstdint>

#include "client/cli/calibration_file.h"

namespace fovea::cli {

// What a camera_info says of how images come from the whole sensor, which its other numbers are of:
// cut out, in pixels of the sensor, where the size is not 0, then binned; 0 is 1.
struct CameraWindow {
  std::uint32_t binning_x = 0, binning_y = 0;
  std::uint32_t x_offset = 0, y_offset = 0, width = 0, height = 0;  // the field roi
};

// Of the sensor → of its images, as ROS's image_geometry does it. Throws std::invalid_argument that
// names the field where no image is left.
void Apply(const CameraWindow& window, Calibration* calibration);

}  // namespace fovea::cli
