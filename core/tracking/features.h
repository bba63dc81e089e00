// Points of a frame that can be found again in another one.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <utility>
#include <vector>

#include "core/types/rgbd_frame.h"

namespace fovea {

struct Features {
  cv::Mat descriptors;                  // CV_8UC1, a row each
  std::vector<Eigen::Vector3d> points;  // camera frame, metres
  std::vector<Eigen::Vector2d> pixels;  // of the frame
  std::vector<char> on_object;          // they may move
};

// ORB (Rublee et al. 2011) where depth is measured and is about the same all around, at most
// kMaxFeatures of them, in the image scaled to a width of at most 640. `labels`: CV_16UC1 of the
// frame's size, 0 = background. Costs some 8 ms.
constexpr int kMaxFeatures = 800;
Features FindFeatures(const RgbdFrame& frame, const cv::Mat& labels);

// Pairs of indices, each other's nearest descriptor. Costs some 3 ms.
std::vector<std::pair<int, int>> MatchFeatures(const Features& from, const Features& to);

}  // namespace fovea
