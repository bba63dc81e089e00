#include "core/segmentation/lower_border.h"

#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>

#include "core/depth/depth_gap.h"
#include "core/scene/image_direction.h"
#include "core/segmentation/beyond_border.h"
#include "core/segmentation/labels.h"
#include "core/types/interruption.h"
#include "core/types/pixels.h"

namespace fovea {
namespace {

constexpr double kEdgePx = 2;  // in an image 640 wide

}  // namespace

std::vector<LowerBorder> FindLowerBorders(const cv::Mat& labels, const cv::Mat& points,
                                          const CameraIntrinsics& intrinsics,
                                          const Eigen::Vector3f& up,
                                          const std::vector<char>& looked_at) {
  std::vector<LowerBorder> borders(looked_at.size());
  const int edge_px = ScaledPx(kEdgePx, labels.cols, 1);
  cv::Mat depth_m;
  cv::extractChannel(points, depth_m, 2);
  for (int row = 0; row < labels.rows; ++row) {
    InterruptionPoint();
    const auto* label = labels.ptr<std::uint16_t>(row);
    for (int col = 0; col < labels.cols; ++col) {
      if (label[col] == 0 || !looked_at[label[col]] || IsInterior(labels, row, col)) continue;
      const cv::Vec3f& p = points.at<cv::Vec3f>(row, col);
      const auto up_px = UpInImage({p[0], p[1], p[2]}, intrinsics, up);
      if (!up_px) continue;
      const auto below_m = DepthBeyond(labels, depth_m, {col, row}, -*up_px, edge_px);
      if (!below_m || std::isnan(*below_m)) continue;
      ++borders[label[col]].num_pixels;
      if (*below_m > p[2] + DepthGap_m(p[2])) ++borders[label[col]].num_free;
      if (*below_m < p[2] - DepthGap_m(p[2])) ++borders[label[col]].num_hidden;
    }
  }
  return borders;
}

}  // namespace fovea
