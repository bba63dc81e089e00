#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "client/cli/overlay/badges.h"
#include "client/cli/overlay/view.h"
#include "fovea/v1/detection.pb.h"

namespace fovea::cli {

// Of each gripper that has one.
std::vector<const v1::Grasp*> LikeliestGrasps(const v1::Object& object);

// The object's likeliest grasp of each gripper as that gripper, with its probability in a badge;
// `all`: the others, too, as outlines.
void DrawGrasps(cv::Mat& picture, const v1::Object& object,
                const google::protobuf::RepeatedPtrField<v1::Gripper>& grippers, const View& view,
                bool all, Badges& badges);

// (B, G, R): from red (0) over yellow to green (1).
cv::Scalar ColorOfProbability(double probability);

}  // namespace fovea::cli
