// A height map for people.
#pragma once

#include <opencv2/core/mat.hpp>

#include "fovea/v1/detection.pb.h"

namespace fovea::cli {

// The answer's height map from above, the way that the camera looks upwards (CV_8UC3, B first):
// low is dark, high is bright, hatched grey is unknown, objects have their numbers, and what
// colours mean stands below. Throws std::runtime_error for a map whose data do not fit its size.
cv::Mat HeightPicture(const v1::Detections& detections);

}  // namespace fovea::cli
