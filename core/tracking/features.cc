#include "core/tracking/features.h"

#include <algorithm>
#include <cmath>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "core/depth/measured_depth.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr int kMaxWidth_px = 640;

struct ScaledGray {
  cv::Mat gray;
  double scale;  // of the frame
};

ScaledGray GrayOf(const cv::Mat& color_rgb) {
  const double scale = std::min(1.0, static_cast<double>(kMaxWidth_px) / color_rgb.cols);
  cv::Mat color = color_rgb, gray;
  if (scale < 1) {
    const cv::Size size(kMaxWidth_px, std::max(1, cvRound(color_rgb.rows * scale)));
    cv::resize(color_rgb, color, size, 0, 0, cv::INTER_AREA);
  }
  cv::cvtColor(color, gray, cv::COLOR_RGB2GRAY);
  return {gray, scale};
}

// Depth at a pixel, or NaN where an edge or a hole is near: the corner of a thing is seen before
// whatever is behind it.
float SteadyDepth(const cv::Mat& depth_m, int x, int y) {
  constexpr int kReach_px = 2;
  constexpr float kMaxStep = 0.02F;  // of the depth
  const cv::Rect around(x - kReach_px, y - kReach_px, 2 * kReach_px + 1, 2 * kReach_px + 1);
  if ((around & cv::Rect({0, 0}, depth_m.size())) != around) return std::nanf("");
  const float depth = depth_m.at<float>(y, x);
  if (!IsMeasured(depth)) return std::nanf("");
  for (int row = around.y; row < around.br().y; ++row) {
    for (int column = around.x; column < around.br().x; ++column) {
      const float other = depth_m.at<float>(row, column);
      if (!(std::abs(other - depth) < kMaxStep * depth)) return std::nanf("");
    }
  }
  return depth;
}

}  // namespace

Features FindFeatures(const RgbdFrame& frame, const cv::Mat& labels) {
  constexpr float kPyramidStep = 1.2F;
  constexpr int kLevels = 4, kEdge_px = 15, kPatch_px = 31;
  constexpr int kFastThreshold = 8;  // floors and tables have little contrast
  const ScaledGray scaled = GrayOf(frame.color_rgb);
  const cv::Ptr<cv::ORB> orb = cv::ORB::create(kMaxFeatures, kPyramidStep, kLevels, kEdge_px, 0, 2,
                                               cv::ORB::HARRIS_SCORE, kPatch_px, kFastThreshold);
  std::vector<cv::KeyPoint> corners;
  cv::Mat descriptors;
  orb->detectAndCompute(scaled.gray, cv::noArray(), corners, descriptors);
  InterruptionPoint();

  const CameraIntrinsics& k = frame.intrinsics;
  Features features;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double u = (corners[i].pt.x + 0.5) / scaled.scale - 0.5;
    const double v = (corners[i].pt.y + 0.5) / scaled.scale - 0.5;
    const int x = cvRound(u), y = cvRound(v);
    const float depth = SteadyDepth(frame.depth_m, x, y);
    if (std::isnan(depth)) continue;
    features.descriptors.push_back(descriptors.row(static_cast<int>(i)));
    features.points.emplace_back((u - k.cx_px) / k.fx_px * depth, (v - k.cy_px) / k.fy_px * depth,
                                 depth);
    features.pixels.emplace_back(u, v);
    features.on_object.push_back(labels.at<std::uint16_t>(y, x) != 0);
  }
  return features;
}

std::vector<std::pair<int, int>> MatchFeatures(const Features& from, const Features& to) {
  std::vector<std::pair<int, int>> pairs;
  if (from.points.empty() || to.points.empty()) return pairs;
  std::vector<cv::DMatch> matches;
  cv::BFMatcher(cv::NORM_HAMMING, /*crossCheck=*/true)
      .match(from.descriptors, to.descriptors, matches);
  for (const cv::DMatch& match : matches) pairs.emplace_back(match.queryIdx, match.trainIdx);
  return pairs;
}

}  // namespace fovea
