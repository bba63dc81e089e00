#include "core/tracking/sighting.h"

#include <algorithm>
#include <opencv2/core.hpp>

#include "core/types/lab.h"

namespace fovea {
namespace {

// One conversion for all of them.
std::vector<Eigen::Vector3f> LabColors(const std::vector<DetectedObject>& objects,
                                       std::size_t count) {
  std::vector<Eigen::Vector3f> colors;
  if (count == 0) return colors;
  cv::Mat rgb(1, static_cast<int>(count), CV_8UC3);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& color = objects[i].mean_color;
    rgb.at<cv::Vec3b>(static_cast<int>(i)) = {color[0], color[1], color[2]};
  }
  const cv::Mat lab = LabOf(rgb);
  for (int i = 0; i < lab.cols; ++i) {
    const cv::Vec3b& c = lab.at<cv::Vec3b>(i);
    colors.emplace_back(c[0] * 100.0F / 255, c[1] - 128.0F, c[2] - 128.0F);
  }
  return colors;
}

std::vector<Eigen::Vector3f> SampleOf(const DetectedObject& object) {
  std::vector<Eigen::Vector3f> points;
  // Clouds run along the rows: every n-th of their points spreads over all of the mask.
  const std::size_t step =
      std::max<std::size_t>(1, (object.cloud.size() + kMaxSightingPoints - 1) / kMaxSightingPoints);
  for (std::size_t i = step / 2; i < object.cloud.size(); i += step) {
    const ColoredPoint& p = object.cloud[i];
    points.emplace_back(p.x, p.y, p.z);
  }
  if (points.empty()) points.push_back(object.centroid);
  return points;
}

}  // namespace

std::vector<Sighting> SightingsOf(const Detections& detections, const CameraIntrinsics& intrinsics,
                                  std::size_t max_count) {
  const std::size_t count = std::min(max_count, detections.objects.size());
  const std::vector<Eigen::Vector3f> colors = LabColors(detections.objects, count);
  std::vector<Sighting> sightings(count);
  for (std::size_t i = 0; i < count; ++i) {
    const DetectedObject& object = detections.objects[i];
    const double side_m2 =
        object.centroid.z() * object.centroid.z() / (intrinsics.fx_px * intrinsics.fy_px);
    sightings[i] = {object.label,
                    object.confidence,
                    object.box,
                    object.uncertainty,
                    object.centroid,
                    colors[i],
                    static_cast<float>(static_cast<double>(object.num_pixels) * side_m2),
                    SampleOf(object)};
  }
  return sightings;
}

OrientedBox Moved(OrientedBox box, const Eigen::Isometry3f& to_from_own) {
  box.center = to_from_own * box.center;
  box.rotation = to_from_own.linear() * box.rotation;
  return box;
}

Sighting Moved(Sighting sighting, const Eigen::Isometry3f& to_from_own) {
  sighting.box = Moved(sighting.box, to_from_own);
  if (sighting.uncertainty) {
    Eigen::Matrix4f turn = Eigen::Matrix4f::Identity();
    turn.topLeftCorner<3, 3>() = to_from_own.linear();
    Eigen::Matrix4f& covariance = sighting.uncertainty->pose_covariance;
    covariance = (turn * covariance * turn.transpose()).eval();
  }
  sighting.centroid = to_from_own * sighting.centroid;
  for (Eigen::Vector3f& point : sighting.points) point = to_from_own * point;
  return sighting;
}

}  // namespace fovea
