#include "core/objects/upper_border.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace fovea {
namespace {

constexpr float kMinSlope = 0.3F;  // of up against the viewing ray, as a sine
constexpr int kEdgePx = 6;         // pixels that sensors mix at an edge
constexpr int kReachPx = 20;       // how far to look for depth beyond it

// Depths closer than this are one surface; grows like the noise of such cameras.
float DepthGap_m(float z_m) { return 0.015F + 0.012F * z_m * z_m; }

Eigen::Vector3f PointAt(const cv::Mat& points, const cv::Point& pixel) {
  const cv::Vec3f& p = points.at<cv::Vec3f>(pixel);
  return {p[0], p[1], p[2]};
}

// The direction in the image, in pixels, in which a point moves when it rises.
std::optional<cv::Point2f> UpInImage(const Eigen::Vector3f& point, const CameraIntrinsics& k,
                                     const Eigen::Vector3f& up) {
  const Eigen::Vector3f ray = point.normalized();
  if ((up - up.dot(ray) * ray).norm() < kMinSlope) return std::nullopt;
  const float slope_x = up.x() - up.z() * point.x() / point.z();
  const float slope_y = up.y() - up.z() * point.y() / point.z();
  const cv::Point2f direction(slope_x * static_cast<float>(k.fx_px),
                              slope_y * static_cast<float>(k.fy_px));
  return direction / static_cast<float>(cv::norm(direction));
}

class Search {
 public:
  Search(const cv::Mat& labels, const cv::Mat& points, const cv::Mat& on_wall,
         const Eigen::Vector3f& up)
      : labels_(labels), points_(points), on_wall_(on_wall), up_(up) {}

  // Counts what lies beyond a pixel of a segment if its border is there.
  void Count(const cv::Point& pixel, const cv::Point2f& direction, UpperBorder& border) const {
    const std::uint16_t label = labels_.at<std::uint16_t>(pixel);
    const cv::Rect image({}, labels_.size());
    for (int step = 1; step <= kReachPx; ++step) {
      const cv::Point beyond(cvRound(static_cast<float>(pixel.x) + step * direction.x),
                             cvRound(static_cast<float>(pixel.y) + step * direction.y));
      if (!image.contains(beyond)) {
        ++border.cut;
        return;
      }
      const std::uint16_t other = labels_.at<std::uint16_t>(beyond);
      if (other == label) return;
      if (other != 0) {
        ++border.open;
        return;
      }
      if (step < kEdgePx || std::isnan(points_.at<cv::Vec3f>(beyond)[2])) continue;
      Compare(pixel, beyond, border);
      return;
    }
    ++border.open;  // nothing measured
  }

 private:
  void Compare(const cv::Point& pixel, const cv::Point& beyond_px, UpperBorder& border) const {
    const Eigen::Vector3f own = PointAt(points_, pixel);
    const Eigen::Vector3f beyond = PointAt(points_, beyond_px);
    const bool on_wall = on_wall_.at<std::uint8_t>(beyond_px) != 0;
    const float step_m = beyond.z() - own.z();
    const float gap_m = DepthGap_m(own.z());
    if (step_m < -gap_m) {
      ++border.hidden;
    } else if (!on_wall && step_m <= gap_m && up_.dot(beyond - own) > 0.004F * own.z()) {
      ++border.attached;
    } else {
      ++border.open;
    }
  }

  const cv::Mat& labels_;
  const cv::Mat& points_;
  const cv::Mat& on_wall_;
  const Eigen::Vector3f& up_;
};

}  // namespace

std::vector<UpperBorder> FindUpperBorders(const cv::Mat& labels, const cv::Mat& points,
                                          const cv::Mat& on_wall,
                                          const CameraIntrinsics& intrinsics,
                                          const Eigen::Vector3f& up) {
  std::vector<UpperBorder> borders(1);
  const Search search(labels, points, on_wall, up);
  for (int row = 0; row < labels.rows; ++row) {
    const auto* label = labels.ptr<std::uint16_t>(row);
    for (int col = 0; col < labels.cols; ++col) {
      if (label[col] == 0) continue;
      if (label[col] >= borders.size()) borders.resize(label[col] + std::size_t{1});
      const cv::Point pixel(col, row);
      const auto direction = UpInImage(PointAt(points, pixel), intrinsics, up);
      if (direction) search.Count(pixel, *direction, borders[label[col]]);
    }
  }
  return borders;
}

}  // namespace fovea
