#include "client/cli/depth_points.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "client/cli/geometry.h"

namespace fovea::cli {
namespace {

// A point this much farther away than another one beside it is hidden behind that.
constexpr double kHiddenBehind = 1.05;

cv::Vec3d PointOf(int x, int y, double z, const v1::CameraIntrinsics& k) {
  return {(x - k.cx()) / k.fx() * z, (y - k.cy()) / k.fy() * z, z};
}

std::vector<DepthPoint> RegisteredPoints(const cv::Mat& depth, const FrameSettings& settings) {
  std::vector<DepthPoint> points;
  for (int y = 0; y < depth.rows; ++y) {
    for (int x = 0; x < depth.cols; ++x) {
      const double z = depth.at<std::uint16_t>(y, x) * settings.depth_unit_m;
      if (z != 0) points.push_back({PointOf(x, y, z, settings.intrinsics), {x, y}});
    }
  }
  return points;
}

// Those in the colour image, hidden or not.
std::vector<DepthPoint> ProjectedPoints(const cv::Mat& depth, const FrameSettings& settings,
                                        const cv::Size& color_size) {
  const v1::CameraIntrinsics& k = settings.intrinsics;
  const v1::Pose& pose = settings.depth_camera->color_from_depth;
  const cv::Matx33d rotation = RotationOf(pose.orientation());
  const cv::Vec3d translation = ToVec(pose.position());
  const cv::Rect2d image(-0.5, -0.5, color_size.width, color_size.height);
  std::vector<DepthPoint> points;
  for (int y = 0; y < depth.rows; ++y) {
    for (int x = 0; x < depth.cols; ++x) {
      const double z = depth.at<std::uint16_t>(y, x) * settings.depth_unit_m;
      const cv::Vec3d p =
          rotation * PointOf(x, y, z, settings.depth_camera->intrinsics) + translation;
      if (z == 0 || !(p[2] > 0.01)) continue;
      const cv::Point2d pixel(k.fx() * p[0] / p[2] + k.cx(), k.fy() * p[1] / p[2] + k.cy());
      if (!image.contains(pixel)) continue;
      points.push_back({p,
                        {std::clamp(cvRound(pixel.x), 0, color_size.width - 1),
                         std::clamp(cvRound(pixel.y), 0, color_size.height - 1)}});
    }
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
