#include "server/conversion/frame.h"

#include <google/protobuf/util/time_util.h>

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <utility>

#include "core/lens/undistortion.h"
#include "server/conversion/depth_camera.h"
#include "server/conversion/depth_notes.h"
#include "server/conversion/field_error.h"
#include "server/conversion/frame_notes.h"
#include "server/conversion/geometry.h"
#include "server/conversion/image.h"
#include "server/conversion/intrinsics.h"

namespace fovea::server {
namespace {

using google::protobuf::util::TimeUtil;

constexpr std::size_t kMaxIdBytes = 256;

// JSON knows no other times, nor does Timestamp.
void RequireTime(const google::protobuf::Timestamp& time) {
  RequireField(
      time.seconds() >= TimeUtil::kTimestampMinSeconds &&
          time.seconds() <= TimeUtil::kTimestampMaxSeconds,
      "frame.captured_at",
      "is " + std::to_string(time.seconds()) + " s after 1970; it must lie in the years 1 to 9999");
  RequireField(time.nanos() >= 0 && time.nanos() <= 999'999'999, "frame.captured_at",
               "has " + std::to_string(time.nanos()) + " nanos, which must be 0 to 999999999");
}

void RequireParts(const v1::Frame& frame) {
  RequireField(frame.id().size() <= kMaxIdBytes, "frame.id",
               "has " + std::to_string(frame.id().size()) + " bytes, at most " +
                   std::to_string(kMaxIdBytes) + " are allowed");
  RequireTime(frame.captured_at());
  RequireField(frame.has_color(), "frame.color",
               "is missing; send RGB8 or BGR8 rows, or a JPEG or PNG file");
  RequireField(frame.has_depth(), "frame.depth",
               "is missing; send for example 16UC1 in millimetres, registered to colour");
  RequireField(frame.has_intrinsics(), "frame.intrinsics",
               "is missing; send fx, fy, cx, cy of the colour camera in pixels");
}

Eigen::Vector3f GravityFromProto(const v1::Vector3& proto) {
  const Eigen::Vector3d gravity = FromProto(proto);
  const double length = gravity.norm();
  RequireField(std::isfinite(length) && std::abs(length - 1) <= 0.1, "frame.gravity",
               "must be a unit vector that points down; its length is " + std::to_string(length));
  return gravity.normalized().cast<float>();
}

void RequireSameSize(const cv::Mat& color, const cv::Mat& depth) {
  const auto text = [](const cv::Mat& image) {
    return std::to_string(image.cols) + "x" + std::to_string(image.rows);
  };
  RequireField(color.size() == depth.size(), "frame.depth",
               "is " + text(depth) + ", colour is " + text(color) +
                   "; depth must be registered to colour and have its size, or else "
                   "frame.depth_intrinsics and frame.color_from_depth are needed");
}

void Say(const std::optional<std::string>& note, std::vector<std::string>* messages) {
  if (note && messages != nullptr) messages->push_back(*note);
}

}  // namespace

RgbdFrame FromProto(const v1::Frame& frame, std::uint64_t max_pixels,
                    std::vector<std::string>* messages, std::optional<Lens>* lens) {
  RequireParts(frame);
  RgbdFrame result;
  // What is cheap to check comes before the images.
  result.intrinsics = FromProto(frame.intrinsics(), "frame.intrinsics");
  if (frame.has_gravity()) result.gravity = GravityFromProto(frame.gravity());
  if (frame.has_camera_pose()) FromProto(frame.camera_pose(), "frame.camera_pose");
  const std::optional<DepthCamera> depth_camera = DepthCameraFromProto(frame);

  result.color_rgb = ColorFromProto(frame.color(), max_pixels);
  RequirePlausible(result.intrinsics, result.color_rgb.size(), "frame.intrinsics");
  Say(OddIntrinsics(result.intrinsics, result.color_rgb.size(), "frame.intrinsics"), messages);
  const std::optional<Lens> of_color =
      LensFromProto(frame.intrinsics(), result.color_rgb.size(), "frame.intrinsics");
  result.depth_m = DepthFromProto(frame.depth(), max_pixels);
  Say(OddDepth(result.depth_m, frame.depth()), messages);
  if (depth_camera) {
    Say(OddIntrinsics(depth_camera->intrinsics, result.depth_m.size(), "frame.depth_intrinsics"),
        messages);
    RegisteredDepth registered = Register(result.depth_m, *depth_camera, result.intrinsics,
                                          result.color_rgb.size(), messages);
    result.depth_m = std::move(registered.depth_m);
    result.unseen = std::move(registered.unseen);
  }
  RequireSameSize(result.color_rgb, result.depth_m);
  if (of_color) {
    result.color_rgb = UndistortColor(result.color_rgb, *of_color);
    const cv::Mat unseen = UnseenBy(*of_color);
    result.unseen = result.unseen.empty() ? unseen : cv::Mat(result.unseen | unseen);
    if (depth_camera) {
      // As if it had come registered: what colour does not show is not looked at.
      result.depth_m.setTo(std::numeric_limits<float>::quiet_NaN(), unseen);
    } else {
      result.depth_m = UndistortDepth(result.depth_m, *of_color);
    }
  }
  if (lens != nullptr) *lens = of_color;
  InField("frame", [&] { Validate(result); });
  return result;
}

}  // namespace fovea::server
