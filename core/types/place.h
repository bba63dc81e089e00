// Where on a support something can be put down. Camera frame, metres.
#pragma once

#include <Eigen/Core>

namespace fovea {

struct PlaceOptions {
  Eigen::Vector3f size_m{0, 0, 0};  // of what shall be put down: length, width, height; above 0
  float margin_m = 0.02F;           // kept free around it, and to edges and to what is unseen
  int max_places = 5;               // the ones with most room
};

}  // namespace fovea
