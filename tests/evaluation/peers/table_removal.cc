#include "tests/evaluation/peers/table_removal.h"

#include <pcl/segmentation/sac_segmentation.h>

#include <Eigen/Core>
#include <limits>
#include <map>

#include "core/depth/back_projection.h"

namespace fovea::evaluation {
namespace {

PixelCloud CloudOf(const RgbdFrame& frame) {
  const cv::Mat positions =
      BackProject(frame.depth_m, frame.intrinsics, std::numeric_limits<double>::infinity());
  PixelCloud cloud{std::make_shared<PeerCloud>(), {}};
  for (int y = 0; y < positions.rows; ++y) {
    for (int x = 0; x < positions.cols; ++x) {
      const auto& at = positions.at<cv::Vec3f>(y, x);
      if (!(at[2] > 0)) continue;  // NaN
      const auto& rgb = frame.color_rgb.at<cv::Vec3b>(y, x);
      cloud.points->emplace_back(at[0], at[1], at[2], rgb[0], rgb[1], rgb[2], 255);
      cloud.pixels.emplace_back(x, y);
    }
  }
  return cloud;
}

// (n, d) of n·x + d = 0 with the camera on the positive side; 0 where there is no plane.
Eigen::Vector4f LargestPlane(const PeerCloud::Ptr& cloud, const TableRemovalOptions& options) {
  pcl::SACSegmentation<pcl::PointXYZRGBA> search;
  search.setModelType(pcl::SACMODEL_PLANE);
  search.setMethodType(pcl::SAC_RANSAC);
  search.setOptimizeCoefficients(true);
  search.setDistanceThreshold(options.tolerance_m);
  search.setMaxIterations(options.iterations);
  search.setInputCloud(cloud);
  pcl::PointIndices inliers;
  pcl::ModelCoefficients plane;
  if (cloud->size() >= 3) search.segment(inliers, plane);
  if (inliers.indices.empty()) return Eigen::Vector4f::Zero();
  const Eigen::Vector4f found = Eigen::Map<const Eigen::Vector4f>(plane.values.data());
  return found[3] < 0 ? Eigen::Vector4f(-found) : found;
}

}  // namespace

PixelCloud CloudAboveTable(const RgbdFrame& frame, const TableRemovalOptions& options) {
  const PixelCloud all = CloudOf(frame);
  const Eigen::Vector4f plane = LargestPlane(all.points, options);
  if (plane.isZero()) return all;
  PixelCloud above{std::make_shared<PeerCloud>(), {}};
  for (std::size_t i = 0; i < all.pixels.size(); ++i) {
    const pcl::PointXYZRGBA& point = (*all.points)[i];
    if (plane.head<3>().dot(point.getVector3fMap()) + plane[3] < options.min_height_m) continue;
    above.points->push_back(point);
    above.pixels.push_back(all.pixels[i]);
  }
  return above;
}

cv::Mat LabelsOfPoints(const PixelCloud& cloud, const std::vector<std::uint32_t>& segments,
                       const cv::Size& size, int min_pixels) {
  std::map<std::uint32_t, int> sizes;
  for (const std::uint32_t segment : segments) ++sizes[segment];
  std::map<std::uint32_t, std::uint16_t> label_of;
  for (const auto& [segment, pixels] : sizes) {
    if (segment == 0 || pixels < min_pixels) continue;
    label_of.emplace(segment, static_cast<std::uint16_t>(label_of.size() + 1));
  }
  cv::Mat labels = cv::Mat::zeros(size, CV_16UC1);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto found = label_of.find(segments[i]);
    if (found != label_of.end()) labels.at<std::uint16_t>(cloud.pixels[i]) = found->second;
  }
  return labels;
}

}  // namespace fovea::evaluation
