#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "fovea/v1/frame.pb.h"

namespace fovea::cli {

inline constexpr const char* kCoeffs = "coeffs";

// Of JSON with the fields of librealsense's intrinsics: "coeffs", which it has, and "model" (or
// "distortion_model"), as pyrealsense2 prints it: "Brown Conrady", "distortion.brown_conrady", 4;
// or one of ROS's names. None where all are 0. Throws std::runtime_error that names the field where
// the model is another and they are not.
std::optional<v1::LensDistortion> DistortionOfCoeffs(const nlohmann::json& json);

}  // namespace fovea::cli
