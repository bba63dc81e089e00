#include "client/pcl/clouds.h"

#include <google/protobuf/util/time_util.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "client/images.h"
#include "client/mask.h"
#include "client/pcl/organized.h"

namespace fovea::client {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZRGB>;

// Clouds of PCL have microseconds, 0 where there is no time.
google::protobuf::Timestamp TimeOf(std::uint64_t stamp_us) {
  constexpr std::uint64_t kLastMicrosecond = 253'402'300'799'999'999;  // of the year 9999
  if (stamp_us > kLastMicrosecond) {
    throw std::invalid_argument("the cloud's header.stamp " + std::to_string(stamp_us) +
                                " is no time: it must be microseconds since 1970, at most " +
                                std::to_string(kLastMicrosecond));
  }
  return google::protobuf::util::TimeUtil::MicrosecondsToTimestamp(
      static_cast<std::int64_t>(stamp_us));
}

}  // namespace

v1::Frame ToFrame(const Cloud& cloud, const v1::CameraIntrinsics& intrinsics) {
  RequireOrganized(cloud);
  std::vector<std::uint8_t> color;
  std::vector<float> depth;
  color.reserve(3 * cloud.size());
  depth.reserve(cloud.size());
  for (const pcl::PointXYZRGB& point : cloud) {
    color.insert(color.end(), {point.r, point.g, point.b});
    depth.push_back(HasDepth(point) ? point.z : std::numeric_limits<float>::quiet_NaN());
  }
  v1::Frame frame;
  *frame.mutable_color() =
      MakeColorImage(color.data(), cloud.width, cloud.height, v1::COLOR_ENCODING_RGB8);
  *frame.mutable_depth() = MakeDepthImage(depth.data(), cloud.width, cloud.height);
  *frame.mutable_intrinsics() = intrinsics;
  if (cloud.header.stamp != 0) *frame.mutable_captured_at() = TimeOf(cloud.header.stamp);
  return frame;
}

Cloud ToPcl(const v1::PointCloud& cloud) {
  const int count = cloud.positions_size() / 3;
  if (cloud.positions_size() % 3 != 0 ||
      cloud.colors().size() != static_cast<std::size_t>(cloud.positions_size())) {
    throw std::runtime_error("the server's answer has a broken cloud");
  }
  Cloud points;
  points.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    pcl::PointXYZRGB point;
    point.x = cloud.positions(3 * i);
    point.y = cloud.positions(3 * i + 1);
    point.z = cloud.positions(3 * i + 2);
    const auto color = [&](int channel) {
      return static_cast<std::uint8_t>(cloud.colors()[static_cast<std::size_t>(3 * i + channel)]);
    };
    point.r = color(0);
    point.g = color(1);
    point.b = color(2);
    points.push_back(point);
  }
  return points;
}

pcl::PointIndices IndicesOf(const v1::Object& object, std::uint32_t width) {
  if (!object.has_mask()) {
    throw std::invalid_argument("object " + std::to_string(object.label()) +
                                " has no mask; ask for it with DetectOptions.return_masks");
  }
  const v1::BoundingBox2D& bounds = object.mask().bounds();
  if (std::uint64_t{bounds.x()} + bounds.width() > width) {
    throw std::runtime_error("the server's answer has an object outside of the image");
  }
  const std::vector<std::uint8_t> pixels = DecodeMask(object.mask());
  pcl::PointIndices indices;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (pixels[i] == 0) continue;
    const std::size_t row = bounds.y() + i / bounds.width(), col = bounds.x() + i % bounds.width();
    indices.indices.push_back(static_cast<int>(row * width + col));
  }
  return indices;
}

pcl::PointCloud<pcl::PointXYZRGBL> Labelled(const Cloud& cloud, const v1::Detections& detections) {
  if (cloud.width != detections.width() || cloud.height != detections.height()) {
    throw std::runtime_error("the cloud has not the size of the answer");
  }
  pcl::PointCloud<pcl::PointXYZRGBL> labelled;
  labelled.header = cloud.header;
  labelled.resize(cloud.size());
  labelled.width = cloud.width;
  labelled.height = cloud.height;
  labelled.is_dense = cloud.is_dense;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    labelled[i].x = cloud[i].x;
    labelled[i].y = cloud[i].y;
    labelled[i].z = cloud[i].z;
    labelled[i].rgba = cloud[i].rgba;
    labelled[i].label = 0;
  }
  for (const v1::Object& object : detections.objects()) {
    for (const int index : IndicesOf(object, cloud.width).indices) {
      labelled.at(static_cast<std::size_t>(index)).label = object.label();
    }
  }
  return labelled;
}

Eigen::Isometry3d ToEigen(const v1::Pose& pose) {
  const auto& q = pose.orientation();
  Eigen::Isometry3d transform(Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()));
  transform.translation() << pose.position().x(), pose.position().y(), pose.position().z();
  return transform;
}

}  // namespace fovea::client
