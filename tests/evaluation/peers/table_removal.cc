#include "tests/evaluation/peers/table_removal.h"

#include <pcl/sample_consensus/ransac.h>
#include <pcl/sample_consensus/sac_model_plane.h>

#include <Eigen/Core>
#include <map>
#include <numeric>

namespace fovea::evaluation {
namespace {

PixelCloud CloudOf(const RgbdFrame& frame) {
  const CameraIntrinsics& camera = frame.intrinsics;
  PixelCloud cloud{std::make_shared<PeerCloud>(), {}};
  for (int y = 0; y < frame.depth_m.rows; ++y) {
    for (int x = 0; x < frame.depth_m.cols; ++x) {
      const float z = frame.depth_m.at<float>(y, x);
      if (!(z > 0)) continue;  // NaN
      const auto& rgb = frame.color_rgb.at<cv::Vec3b>(y, x);
      cloud.points->emplace_back(static_cast<float>((x - camera.cx_px) / camera.fx_px) * z,
                                 static_cast<float>((y - camera.cy_px) / camera.fy_px) * z, z,
                                 rgb[0], rgb[1], rgb[2], 255);
      cloud.pixels.emplace_back(x, y);
    }
  }
  return cloud;
}

// (n, d) of n·x + d = 0 with the camera on the positive side; 0 where there is no plane. As
// pcl::SACSegmentation finds it, without the other models that it would compile.
Eigen::Vector4f LargestPlane(const PeerCloud::Ptr& cloud, const TableRemovalOptions& options) {
  if (cloud->size() < 3) return Eigen::Vector4f::Zero();
  pcl::Indices all(cloud->size());
  std::iota(all.begin(), all.end(), 0);
  const auto model =
      std::make_shared<pcl::SampleConsensusModelPlane<pcl::PointXYZRGBA>>(cloud, all);
  pcl::RandomSampleConsensus<pcl::PointXYZRGBA> search(model, options.tolerance_m);
  search.setMaxIterations(options.iterations);
  if (!search.computeModel()) return Eigen::Vector4f::Zero();
  pcl::Indices inliers;
  Eigen::VectorXf sampled, plane;
  search.getInliers(inliers);
  search.getModelCoefficients(sampled);
  model->optimizeModelCoefficients(inliers, sampled, plane);
  return plane[3] < 0 ? -plane : plane;
}

}  // namespace

PixelCloud CloudAboveTable(const RgbdFrame& frame, const TableRemovalOptions& options) {
  PixelCloud all = CloudOf(frame);
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
