#include "core/segmentation/lower_border.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core/depth/depth_gap.h"
#include "core/scene/image_direction.h"
#include "core/segmentation/labels.h"

namespace fovea {
namespace {

constexpr double kReachPx = 30;  // wider than the shadow of most things at a width of 640
constexpr int kEdgePx = 3;       // pixels that sensors mix at an edge

// The depth of the first thing below a pixel that is not of its label; none for pixels that are not
// on the lower border, or where nothing was measured.
std::optional<float> DepthBelow(const cv::Mat& labels, const cv::Mat& points,
                                const cv::Point& pixel, const cv::Point2f& up_px) {
  const cv::Rect image({}, labels.size());
  const std::uint16_t label = labels.at<std::uint16_t>(pixel);
  const int reach_px = std::max(kEdgePx + 1, cvRound(kReachPx * labels.cols / 640.0));
  for (int step = 1; step <= reach_px; ++step) {
    const cv::Point below(cvRound(static_cast<float>(pixel.x) - step * up_px.x),
                          cvRound(static_cast<float>(pixel.y) - step * up_px.y));
    if (!image.contains(below) || labels.at<std::uint16_t>(below) == label) return std::nullopt;
    const float z = points.at<cv::Vec3f>(below)[2];
    if (step >= kEdgePx && !std::isnan(z)) return z;
  }
  return std::nullopt;
}

}  // namespace

std::vector<LowerBorder> FindLowerBorders(const cv::Mat& labels, const cv::Mat& points,
                                          const CameraIntrinsics& intrinsics,
                                          const Eigen::Vector3f& up,
                                          const std::vector<char>& looked_at) {
  std::vector<LowerBorder> borders(looked_at.size());
  for (int row = 0; row < labels.rows; ++row) {
    const auto* label = labels.ptr<std::uint16_t>(row);
    for (int col = 0; col < labels.cols; ++col) {
      if (label[col] == 0 || !looked_at[label[col]] || IsInterior(labels, row, col)) continue;
      const cv::Vec3f& p = points.at<cv::Vec3f>(row, col);
      const auto up_px = UpInImage({p[0], p[1], p[2]}, intrinsics, up);
      if (!up_px) continue;
      const auto below_m = DepthBelow(labels, points, {col, row}, *up_px);
      if (!below_m) continue;
      ++borders[label[col]].num_pixels;
      if (*below_m > p[2] + DepthGap_m(p[2])) ++borders[label[col]].num_free;
    }
  }
  return borders;
}

}  // namespace fovea
