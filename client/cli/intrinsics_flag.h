#pragma once

#include <opencv2/core/types.hpp>
#include <string>

#include "fovea/v1/frame.pb.h"

namespace fovea::cli {

struct GivenIntrinsics {
  v1::CameraIntrinsics values;
  std::string path;  // of the file; empty = given as numbers
  cv::Size size;     // of the images that they are for; empty = not said
};

// What a flag says: FX,FY,CX,CY, or the path of a calibration file. Throws std::exception that
// names the flag or the file.
GivenIntrinsics ReadIntrinsics(const std::string& text, const std::string& flag);

// Throws std::runtime_error that names the file.
GivenIntrinsics IntrinsicsInFile(const std::string& path);

// What --distortion says takes the place of what a calibration says; "" leaves that. Throws
// std::invalid_argument that names the flag.
void SetDistortion(const std::string& flag, v1::CameraIntrinsics* intrinsics);

// The calibration that lies in a folder of frames: intrinsics.json, camera_info.yaml or
// intrinsics.txt; empty where there is none.
std::string CalibrationIn(const std::string& folder);

}  // namespace fovea::cli
