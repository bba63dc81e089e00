#pragma once

#include <opencv2/core/types.hpp>
#include <string>

#include "fovea/v1/frame.pb.h"

namespace fovea::cli {

struct GivenIntrinsics {
  v1::CameraIntrinsics values;
  std::string path;        // of the file; empty = given as numbers
  cv::Size size;           // of the images that they are for; empty = not said
  bool distorted = false;  // the lens is, which is not corrected
};

// What a flag says: FX,FY,CX,CY, or the path of a calibration file. Throws std::exception that
// names the flag or the file.
GivenIntrinsics ReadIntrinsics(const std::string& text, const std::string& flag);

// The calibration that lies in a folder of frames: intrinsics.json, camera_info.yaml or
// intrinsics.txt; empty where there is none.
std::string CalibrationIn(const std::string& folder);

}  // namespace fovea::cli
