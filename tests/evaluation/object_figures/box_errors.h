// How far the box of an answer is from the true one.
#pragma once

#include <optional>

#include "tests/evaluation/object_figures/true_box.h"

namespace fovea::evaluation {

struct BoxErrors {
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  // answer − truth along the box axes
  double center_m = 0;                               // distance of the middles
  double iou = 0;                                    // of the volumes
  // Between the x axes seen from above, 0 … 90° (0 … 45° where length and width differ by less than
  // a tenth); none of what is round about the upright.
  std::optional<double> yaw_deg;
};

// `answer`: world frame. Of bodies that are round about the upright the true box has the yaw of the
// answer.
BoxErrors CompareBoxes(const scenes::Body& body, const OrientedBox& answer);

}  // namespace fovea::evaluation
