#include "client/cli/depth_points.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "client/cli/geometry.h"
#include "client/cli/lens.h"

namespace fovea::cli {
namespace {

// A point this much farther away than another one beside it is hidden behind that.
constexpr double kHiddenBehind = 1.05;

cv::Vec3d PointOf(const cv::Vec2d& ray, double z) { return {ray[0] * z, ray[1] * z, z}; }

std::vector<DepthPoint> RegisteredPoints(const cv::Mat& depth, const FrameSettings& settings) {
  const cv::Mat rays = RaysOf(settings.intrinsics, depth.size());
  std::vector<DepthPoint> points;
  for (int y = 0; y < depth.rows; ++y) {
    for (int x = 0; x < depth.cols; ++x) {
      const double z = depth.at<std::uint16_t>(y, x) * settings.depth_unit_m;
      if (z != 0) points.push_back({PointOf(rays.at<cv::Vec2d>(y, x), z), {x, y}});
    }
  }
  return points;
}

// In the frame of the colour camera and before it.
std::vector<cv::Vec3d> PositionsInColor(const cv::Mat& depth, const FrameSettings& settings) {
  constexpr double kNearest_m = 0.01;
  const v1::Pose& pose = settings.depth_camera->color_from_depth;
  const cv::Matx33d rotation = RotationOf(pose.orientation());
  const cv::Vec3d translation = ToVec(pose.position());
  const cv::Mat rays = RaysOf(settings.depth_camera->intrinsics, depth.size());
  std::vector<cv::Vec3d> positions;
  for (int y = 0; y < depth.rows; ++y) {
    for (int x = 0; x < depth.cols; ++x) {
      const double z = depth.at<std::uint16_t>(y, x) * settings.depth_unit_m;
      const cv::Vec3d p = rotation * PointOf(rays.at<cv::Vec2d>(y, x), z) + translation;
      if (z != 0 && p[2] > kNearest_m) positions.push_back(p);
    }
  }
  return positions;
}

// Those in the colour image, hidden or not.
std::vector<DepthPoint> ProjectedPoints(const cv::Mat& depth, const FrameSettings& settings,
                                        const cv::Size& color_size) {
  const cv::Rect2d image(-0.5, -0.5, color_size.width, color_size.height);
  const std::vector<cv::Vec3d> positions = PositionsInColor(depth, settings);
  const std::vector<cv::Point2d> pixels = PixelsOf(positions, settings.intrinsics, color_size);
  std::vector<DepthPoint> points;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (!image.contains(pixels[i])) continue;
    points.push_back({positions[i],
                      {std::clamp(cvRound(pixels[i].x), 0, color_size.width - 1),
                       std::clamp(cvRound(pixels[i].y), 0, color_size.height - 1)}});
  }
  return points;
}

// Compares with the nearest depth in each square of some two by two depth pixels.
std::vector<DepthPoint> WithoutHidden(const std::vector<DepthPoint>& points,
                                      const FrameSettings& settings, const cv::Size& color_size) {
  const double scale = settings.intrinsics.fx() / settings.depth_camera->intrinsics.fx();
  const int side = static_cast<int>(std::ceil(std::clamp(2 * scale, 1.0, 100.0)));
  cv::Mat nearest(color_size.height / side + 1, color_size.width / side + 1, CV_64FC1,
                  cv::Scalar(std::numeric_limits<double>::infinity()));
  const auto nearest_at = [&](const cv::Point& pixel) -> double& {
    return nearest.at<double>(pixel.y / side, pixel.x / side);
  };
  for (const DepthPoint& point : points) {
    nearest_at(point.pixel) = std::min(nearest_at(point.pixel), point.position[2]);
  }
  std::vector<DepthPoint> seen;
  std::copy_if(points.begin(), points.end(), std::back_inserter(seen), [&](const DepthPoint& p) {
    return p.position[2] <= kHiddenBehind * nearest_at(p.pixel);
  });
  return seen;
}

}  // namespace

std::vector<DepthPoint> PointsInColor(const cv::Mat& depth, const FrameSettings& settings,
                                      const cv::Size& color_size) {
  if (settings.depth_camera) {
    return WithoutHidden(ProjectedPoints(depth, settings, color_size), settings, color_size);
  }
  if (depth.size() != color_size) throw std::runtime_error("colour and depth differ in size");
  return RegisteredPoints(depth, settings);
}

}  // namespace fovea::cli
