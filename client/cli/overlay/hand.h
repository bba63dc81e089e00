// A gripper at a grasp, in its size.
#pragma once

#include <vector>

#include "client/cli/overlay/block.h"
#include "fovea/v1/detection.pb.h"

namespace fovea::cli {

// In metres in the camera frame.
struct Hand {
  std::vector<Block> blocks;     // two fingers at the object and a palm; none with suction
  std::vector<SpaceLine> lines;  // of a suction cup: its lip and its tube
  cv::Vec3d back;                // the end away from the object
};

// `grippers`: Detections.grippers.
Hand HandOf(const v1::Grasp& grasp,
            const google::protobuf::RepeatedPtrField<v1::Gripper>& grippers);

}  // namespace fovea::cli
