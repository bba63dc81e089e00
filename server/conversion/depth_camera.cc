#include "server/conversion/depth_camera.h"

#include <opencv2/core.hpp>

#include "core/depth/depth_view.h"
#include "core/depth/registration.h"
#include "core/lens/undistortion.h"
#include "server/conversion/field_error.h"
#include "server/conversion/geometry.h"
#include "server/conversion/intrinsics.h"

namespace fovea::server {
namespace {

constexpr char kIntrinsics[] = "frame.depth_intrinsics", kPose[] = "frame.color_from_depth",
               kPosition[] = "frame.color_from_depth.position";
// Cameras of one sensor or robot; millimetres for metres go beyond.
constexpr double kFarthest_m = 10;

bool HasDepth(const cv::Mat& depth_m) { return cv::countNonZero(depth_m == depth_m) > 0; }

}  // namespace

std::optional<DepthCamera> DepthCameraFromProto(const v1::Frame& frame) {
  if (!frame.has_depth_intrinsics() && !frame.has_color_from_depth()) return std::nullopt;
  RequireField(frame.has_depth_intrinsics(), kIntrinsics,
               "is missing; frame.color_from_depth needs fx, fy, cx, cy of the depth camera");
  RequireField(frame.has_color_from_depth(), kPose,
               "is missing; frame.depth_intrinsics needs the depth camera's pose in the frame of "
               "the colour camera");
  const DepthCamera camera = {FromProto(frame.depth_intrinsics(), kIntrinsics),
                              frame.depth_intrinsics(), FromProto(frame.color_from_depth(), kPose)};
  const double distance_m = camera.color_from_depth.translation().norm();
  RequireField(distance_m <= kFarthest_m, kPosition,
               "is " + std::to_string(distance_m) + " m away, at most 10 m are allowed");
  return camera;
}

RegisteredDepth Register(const cv::Mat& depth_m, const DepthCamera& camera,
                         const CameraIntrinsics& color, const cv::Size& color_size,
                         std::vector<std::string>* messages) {
  RequirePlausible(camera.intrinsics, depth_m.size(), kIntrinsics);
  const std::optional<Lens> lens = LensFromProto(camera.proto, depth_m.size(), kIntrinsics);
  const cv::Mat ideal_m = lens ? UndistortDepth(depth_m, *lens) : depth_m;
  RegisteredDepth registered;
  registered.depth_m = InField(kPose, [&] {
    return RegisterDepth(ideal_m, camera.intrinsics, camera.color_from_depth, color, color_size);
  });
  registered.unseen = UnseenByDepthCamera(registered.depth_m, color,
                                          {camera.intrinsics, camera.color_from_depth,
                                           depth_m.size(), lens ? UnseenBy(*lens) : cv::Mat()});
  if (cv::countNonZero(registered.unseen) == 0) registered.unseen.release();
  if (messages != nullptr && HasDepth(depth_m) && !HasDepth(registered.depth_m)) {
    messages->emplace_back(
        "depth registered by color_from_depth covers 0 pixels of colour: check color_from_depth, "
        "depth_intrinsics and the depth unit");
  }
  return registered;
}

}  // namespace fovea::server
