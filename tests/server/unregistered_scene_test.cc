// The same objects, whether depth comes registered or from a depth camera beside colour.
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <vector>

#include "client/images.h"
#include "client/mask.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/support/depth_camera.h"
#include "tests/support/labelled_frame.h"
#include "tests/support/random_scene.h"

namespace fovea::testing {
namespace {

using scenes::SensorKind;

v1::DetectRequest UnregisteredRequest(const RgbdFrame& frame) {
  const auto width = static_cast<std::uint32_t>(frame.color_rgb.cols);
  const auto height = static_cast<std::uint32_t>(frame.color_rgb.rows);
  const CameraIntrinsics& k = frame.intrinsics;
  v1::DetectRequest request;
  *request.mutable_frame()->mutable_color() =
      client::MakeColorImage(frame.color_rgb.data, width, height, v1::COLOR_ENCODING_RGB8);
  *request.mutable_frame()->mutable_depth() =
      client::MakeDepthImage(frame.depth_m.ptr<float>(), width, height);
  *request.mutable_frame()->mutable_intrinsics() =
      client::MakeIntrinsics(k.fx_px, k.fy_px, k.cx_px, k.cy_px);
  request.mutable_options()->set_return_masks(true);
  return request;
}

void SetDepth(v1::Frame& frame, const cv::Mat& depth_m, const scenes::DepthCamera& camera) {
  const CameraIntrinsics& k = camera.intrinsics;
  const Eigen::Vector3d p = camera.color_from_depth.translation();
  const Eigen::Quaterniond q(camera.color_from_depth.linear());
  *frame.mutable_depth() =
      client::MakeDepthImage(depth_m.ptr<float>(), static_cast<std::uint32_t>(depth_m.cols),
                             static_cast<std::uint32_t>(depth_m.rows));
  *frame.mutable_depth_intrinsics() = client::MakeIntrinsics(k.fx_px, k.fy_px, k.cx_px, k.cy_px);
  *frame.mutable_color_from_depth() =
      client::MakePose(p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w());
}

cv::Mat MaskOf(const v1::Object& object, const cv::Size& frame) {
  const v1::BoundingBox2D& bounds = object.mask().bounds();
  std::vector<std::uint8_t> pixels = client::DecodeMask(object.mask());
  cv::Mat mask = cv::Mat::zeros(frame, CV_8UC1);
  cv::Mat(static_cast<int>(bounds.height()), static_cast<int>(bounds.width()), CV_8UC1,
          pixels.data())
      .copyTo(mask(cv::Rect(static_cast<int>(bounds.x()), static_cast<int>(bounds.y()),
                            static_cast<int>(bounds.width()), static_cast<int>(bounds.height()))));
  return mask;
}

double Iou(const cv::Mat& a, const cv::Mat& b) {
  return double(cv::countNonZero(a & b)) / cv::countNonZero(a | b);
}

TEST(UnregisteredScene, HasTheObjectsOfTheRegisteredOne) {
  // Without a bowl, whose inside depth of a quarter of the pixels may part in two.
  const scenes::Scene scene = scenes::RandomScene("tabletop", 2, {640, 480});
  const scenes::DepthCamera camera = scenes::DepthCameraBeside(0.025, {320, 240});
  v1::DetectRequest request =
      UnregisteredRequest(scenes::MakeFrame(scene, SensorKind::kKinect, 1).frame);
  Loopback loopback;
  const v1::Detections registered = loopback.client.Detect(request).detections();

  SetDepth(*request.mutable_frame(), scenes::MeasureDepth(scene, camera, SensorKind::kKinect, 1),
           camera);
  const v1::Detections found = loopback.client.Detect(request).detections();
  EXPECT_EQ(found.width(), 640U);
  EXPECT_GE(registered.objects_size(), 3);
  EXPECT_EQ(found.objects_size(), registered.objects_size());
  int same = 0;
  const cv::Size size(640, 480);
  for (const v1::Object& a : registered.objects()) {
    for (const v1::Object& b : found.objects()) same += Iou(MaskOf(a, size), MaskOf(b, size)) > 0.7;
  }
  EXPECT_EQ(same, registered.objects_size());
}

}  // namespace
}  // namespace fovea::testing
