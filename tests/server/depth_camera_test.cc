// Frames whose depth is not registered to colour, over the wire.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <mutex>
#include <opencv2/core.hpp>

#include "client/images.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

v1::Pose Shift(double x, double y, double z) { return client::MakePose(x, y, z, 0, 0, 0, 1); }

// The test frame, its depth as that of a camera in the same place.
v1::DetectRequest UnregisteredRequest() {
  v1::DetectRequest request = TestRequest();
  *request.mutable_frame()->mutable_depth_intrinsics() = request.frame().intrinsics();
  *request.mutable_frame()->mutable_color_from_depth() = Shift(0, 0, 0);
  return request;
}

// What the detector gets.
RgbdFrame FrameOf(const v1::DetectRequest& request) {
  std::mutex mutex;
  RgbdFrame seen;
  const auto record = [&](const RgbdFrame& frame, const DetectorOptions& options, Trace* trace,
                          const std::function<bool()>& should_stop) {
    const std::scoped_lock lock(mutex);
    seen.depth_m = frame.depth_m.clone();
    seen.unseen = frame.unseen.clone();
    return FindOne(frame, options, trace, should_stop);
  };
  Loopback(record).client.Detect(request);
  const std::scoped_lock lock(mutex);
  return seen;
}

cv::Mat DepthOf(const v1::DetectRequest& request) { return FrameOf(request).depth_m; }

void ExpectRefused(const v1::DetectRequest& request, const std::string& error_start) {
  Loopback loopback;
  const grpc::Status status = StatusOf([&] { loopback.client.Detect(request); });
  EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_THAT(status.error_message(), StartsWith(error_start));
}

TEST(DepthCamera, InThePlaceOfColorLeavesDepthAsItIs) {
  const cv::Mat depth_m = DepthOf(UnregisteredRequest()), expected = TestMeters();
  ASSERT_EQ(depth_m.size(), expected.size());
  for (int i = 0; i < kWidth * kHeight; ++i) {
    EXPECT_EQ(std::isnan(depth_m.at<float>(i)), std::isnan(expected.at<float>(i))) << i;
    if (std::isnan(expected.at<float>(i))) continue;
    EXPECT_NEAR(depth_m.at<float>(i), expected.at<float>(i), 1e-6) << i;
  }
}

TEST(DepthCamera, MayHaveAnotherSizeThanColor) {
  v1::DetectRequest request = UnregisteredRequest();
  const std::vector<float> meters(8UL * 6, 1.5F);
  *request.mutable_frame()->mutable_depth() = client::MakeDepthImage(meters.data(), 8, 6);
  *request.mutable_frame()->mutable_depth_intrinsics() = client::MakeIntrinsics(7.5, 7.5, 3.5, 2.5);
  const cv::Mat depth_m = DepthOf(request);
  EXPECT_EQ(depth_m.size(), cv::Size(kWidth, kHeight));
  EXPECT_EQ(cv::countNonZero(depth_m == 1.5F), kWidth * kHeight);
}

// Else what is cut off where it ends counts as whole.
TEST(DepthCamera, OfALesserFieldOfViewSaysWhereItEnds) {
  v1::DetectRequest request = UnregisteredRequest();
  const std::vector<float> meters(16UL * kHeight, 1.5F);
  *request.mutable_frame()->mutable_depth() = client::MakeDepthImage(meters.data(), 16, kHeight);
  request.mutable_frame()->mutable_depth_intrinsics()->set_cx(7.5);
  const RgbdFrame frame = FrameOf(request);
  ASSERT_EQ(frame.unseen.size(), frame.depth_m.size());
  const cv::Mat measured = frame.depth_m == frame.depth_m;
  EXPECT_EQ(cv::countNonZero(measured), 16 * kHeight);
  EXPECT_EQ(cv::countNonZero(frame.unseen != ~measured), 0);
  EXPECT_TRUE(FrameOf(UnregisteredRequest()).unseen.empty());
}

// A cushion: what it shows of a pinhole camera's image ends before that does.
TEST(DepthCamera, OfALensSaysWhereThatEnds) {
  v1::DetectRequest request = UnregisteredRequest();
  v1::Frame& frame = *request.mutable_frame();
  const std::vector<float> meters(std::size_t{kWidth} * kHeight, 1.5F);
  *frame.mutable_depth() = client::MakeDepthImage(meters.data(), kWidth, kHeight);
  *frame.mutable_intrinsics() = client::MakeIntrinsics(20, 20, 15.5, 11.5);
  *frame.mutable_depth_intrinsics() = frame.intrinsics();
  const auto lens = client::MakeLensDistortion("plumb_bob", {0.15, 0, 0, 0});
  *frame.mutable_depth_intrinsics()->mutable_distortion() = lens;
  const RgbdFrame seen = FrameOf(request);
  ASSERT_EQ(seen.unseen.size(), seen.depth_m.size());
  // Of the corners it is not known: their rows and columns have no depth at all.
  EXPECT_EQ(cv::countNonZero(seen.unseen == (seen.depth_m == seen.depth_m)), 4);
  EXPECT_GT(cv::countNonZero(seen.unseen), 20);

  // The same of colour, whose margin the depth camera sees.
  frame.mutable_depth_intrinsics()->clear_distortion();
  *frame.mutable_intrinsics()->mutable_distortion() = lens;
  const RgbdFrame colored = FrameOf(request);
  EXPECT_EQ(cv::countNonZero(colored.unseen != seen.unseen), 4);
  EXPECT_EQ(cv::countNonZero(colored.unseen == (colored.depth_m == colored.depth_m)), 0);
}

TEST(DepthCamera, ServesFullHdColor) {
  const cv::Size size(1920, 1080);
  const cv::Mat color(size, CV_8UC3, cv::Scalar(90, 90, 90));
  const cv::Mat depth(480, 640, CV_16UC1, cv::Scalar(1000));
  v1::DetectRequest request = UnregisteredRequest();
  v1::Frame& frame = *request.mutable_frame();
  *frame.mutable_color() = client::MakeColorImage(color.data, 1920, 1080, v1::COLOR_ENCODING_RGB8);
  *frame.mutable_depth() = client::MakeDepthImage(depth.ptr<std::uint16_t>(), 640, 480);
  *frame.mutable_intrinsics() = client::MakeIntrinsics(1500, 1500, 959.5, 539.5);
  *frame.mutable_depth_intrinsics() = client::MakeIntrinsics(480, 480, 319.5, 239.5);
  *frame.mutable_color_from_depth() = Shift(-0.025, 0, 0);
  const cv::Mat depth_m = DepthOf(request);
  EXPECT_EQ(depth_m.size(), size);
  // At 1 m the depth camera sees as far as 0.641 m to the left of colour, which sees 0.64 m.
  EXPECT_EQ(cv::countNonZero(cv::abs(depth_m - 1) < 1e-6), size.area());
}

TEST(DepthCamera, StillHasALimitOfPixels) {
  v1::DetectRequest request = UnregisteredRequest();
  *request.mutable_frame()->mutable_depth() =
      DepthMessage(v1::DEPTH_ENCODING_16UC1, BytesOf(TestDepth()), 100'000, 100'000);
  ExpectRefused(request, "frame.depth.width, height: ");
}

TEST(DepthCamera, NeedsBothFields) {
  v1::DetectRequest request = UnregisteredRequest();
  request.mutable_frame()->clear_color_from_depth();
  ExpectRefused(request, "frame.color_from_depth: is missing");
  request = UnregisteredRequest();
  request.mutable_frame()->clear_depth_intrinsics();
  ExpectRefused(request, "frame.depth_intrinsics: is missing");
}

TEST(DepthCamera, NeedsSoundIntrinsics) {
  const auto refuse = [](double fx, double fy, double cx, double cy, const std::string& field) {
    v1::DetectRequest request = UnregisteredRequest();
    *request.mutable_frame()->mutable_depth_intrinsics() = client::MakeIntrinsics(fx, fy, cx, cy);
    ExpectRefused(request, "frame.depth_intrinsics." + field + ": ");
  };
  refuse(0, 30, 15, 11, "fx");
  refuse(30, -1, 15, 11, "fy");
  refuse(30, 30, NAN, 11, "cx");
  refuse(30, 30, 15, INFINITY, "cy");
}

TEST(DepthCamera, NeedsAPose) {
  const auto refuse = [](const v1::Pose& pose, const std::string& error_start) {
    v1::DetectRequest request = UnregisteredRequest();
    *request.mutable_frame()->mutable_color_from_depth() = pose;
    ExpectRefused(request, "frame.color_from_depth." + error_start);
  };
  refuse({}, "orientation: must be a unit quaternion");
  refuse(client::MakePose(0, 0, 0, 1, 1, 0, 0), "orientation: must be a unit quaternion");
  refuse(client::MakePose(0, 0, 0, NAN, 0, 0, 1), "orientation: must be a unit quaternion");
  refuse(Shift(INFINITY, 0, 0), "position: must be finite");
  // Millimetres.
  refuse(Shift(25, 0, 0), "position: is 25.000000 m away, at most 10 m are allowed");
}

TEST(DepthCamera, ThatLooksElsewhereIsSaidToCoverNothing) {
  v1::DetectRequest request = UnregisteredRequest();
  *request.mutable_frame()->mutable_color_from_depth() = client::MakePose(0, 0, 0, 0, 1, 0, 0);
  Loopback loopback;
  const v1::Diagnostics diagnostics = loopback.client.Detect(request).detections().diagnostics();
  EXPECT_EQ(diagnostics.num_measured(), 0U);
  ASSERT_GT(diagnostics.messages_size(), 0);
  EXPECT_THAT(diagnostics.messages(0),
              HasSubstr("depth registered by color_from_depth covers 0 pixels of colour"));
}

TEST(DepthCamera, WithoutMeasurementsIsNotBlamed) {
  v1::DetectRequest request = UnregisteredRequest();
  request.mutable_frame()->mutable_depth()->set_data(std::string(kDepthBytes, '\0'));
  Loopback loopback;
  const v1::Diagnostics diagnostics = loopback.client.Detect(request).detections().diagnostics();
  ASSERT_GT(diagnostics.messages_size(), 0);
  EXPECT_THAT(diagnostics.messages(0), HasSubstr("no pixel has depth"));
}

}  // namespace
}  // namespace fovea::testing
