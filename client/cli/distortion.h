// Lens distortion as calibrations and flags name it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fovea/v1/frame.pb.h"

namespace fovea::cli {

// The model of ROS's camera_info, empty = plumb_bob, with its coefficients in OpenCV's order; zeros
// after the last one that the contract knows are dropped. None where nothing is distorted: no
// coefficients, or all 0 but for equidistant, which bends rays even then. Throws
// std::invalid_argument.
std::optional<v1::LensDistortion> MakeDistortion(const std::string& model,
                                                 std::vector<double> coefficients);

// The value of --distortion: MODEL=K1,K2,…, or none. Throws std::invalid_argument that names it.
std::optional<v1::LensDistortion> ParseDistortion(const std::string& text);

// The model's name as MakeDistortion reads it.
std::string ModelName(const v1::LensDistortion& distortion);

}  // namespace fovea::cli
