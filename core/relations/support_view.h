// What the pixels of a camera saw of a support.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/scene/support_surface.h"
#include "core/types/detections.h"
#include "core/types/level_axes.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

// Both images have the frame's size.
struct ViewedScene {
  const RgbdFrame& frame;
  const cv::Mat& points;  // CV_32FC3, camera frame; NaN = none. May stand in for what the frame has
                          // no depth of, of which nothing was seen all the same.
  const cv::Mat& labels;  // CV_16UC1, 0 = no object, k = the object with label k
};

// What a pixel tells of the place at which its ray meets the support.
enum class Sight : std::uint8_t {
  kNothing,  // depth that is noise, or no surface (core/depth/flying_pixels.h)
  kSeen,     // the support lies there, and nothing on it
  kNotSeen,  // nothing was measured, something is in front, or the ray goes on beyond it
};

struct SupportView {
  cv::Mat sights;  // CV_8UC1, a Sight each
  // Camera frame. Of what is too low to be told from the support by one point, and of what is not.
  std::vector<Eigen::Vector3f> low, in_the_way;
  Eigen::Vector2f begin = Eigen::Vector2f::Zero(), end = begin;  // of what is seen, along the axes
};

// Of the object with label k at k - 1: whether it begins below `height_m` and stands on the support
// or ends above it. What carries the support is not in the way.
std::vector<char> StandInTheWay(const SupportSurface& surface,
                                const std::vector<DetectedObject>& objects, float height_m);

// `stand_in_the_way`: as above, of the objects of `scene`; all pixels of those are in the way, and
// what else rises less than `height_m` above the support. `options`: by which it was found.
SupportView LookAt(const ViewedScene& scene, const Support& support, const LevelAxes& axes,
                   const std::vector<char>& stand_in_the_way, float height_m,
                   const SupportOptions& options);

}  // namespace fovea
