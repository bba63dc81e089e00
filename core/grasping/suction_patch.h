// What a suction cup would lie on.
#pragma once

#include <Eigen/Core>
#include <array>
#include <opencv2/core/types.hpp>
#include <optional>

#include "core/grasping/grasp_scene.h"

namespace fovea {

// Cosines and sines of the multiples of 45 degrees: places around a lip.
constexpr float kCosineOf45 = 0.70710678F;
constexpr std::array<std::array<float, 2>, 8> kAroundLip = {{{1, 0},
                                                             {kCosineOf45, kCosineOf45},
                                                             {0, 1},
                                                             {-kCosineOf45, kCosineOf45},
                                                             {-1, 0},
                                                             {-kCosineOf45, -kCosineOf45},
                                                             {0, -1},
                                                             {kCosineOf45, -kCosineOf45}}};

struct SuctionPatch {
  Eigen::Vector3f center = Eigen::Vector3f::Zero();  // on the fitted surface, camera frame
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  // unit vector, towards the camera
  float unevenness_m = 0;     // root mean square distance from the fitted surface
  float curvature_per_m = 0;  // of the fitted surface, on the average of all directions
  float covered = 0;          // share of sixteen sectors of the lip with points of the object
  int num_points = 0;
};

// The patch of an object around a place of it, which is seen in `pixel`, under a cup of this
// diameter: a plane, then a round surface over it. None where there are too few points.
std::optional<SuctionPatch> PatchAt(const GraspScene& scene, int label, const cv::Point& pixel,
                                    const Eigen::Vector3f& middle, float diameter_m);

}  // namespace fovea
