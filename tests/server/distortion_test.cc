// Frames of cameras with a lens, over the wire: they are looked at without its distortion, and
// answered in the pixels that were sent.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <opencv2/core.hpp>
#include <vector>

#include "client/images.h"
#include "client/mask.h"
#include "core/lens/lens.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"
#include "tests/support/labelled_frame.h"
#include "tests/support/random_scene.h"

namespace fovea::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::vector<double> kBarrel = {-0.28, 0.08, 0.001, -0.002, 0};

// What the camera with this lens takes of the scene, from an ideal image of it.
struct SentFrame {
  cv::Mat color, depth_m, labels;
};

SentFrame Distorted(const scenes::LabelledFrame& ideal, const Lens& lens) {
  const cv::Size size = lens.size();
  SentFrame sent{cv::Mat::zeros(size, CV_8UC3), cv::Mat::zeros(size, CV_32FC1),
                 cv::Mat::zeros(size, CV_16UC1)};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const cv::Point2d from = lens.Undistort(cv::Point2d(x, y));
      if (std::isnan(from.x)) continue;
      const cv::Point pixel = from;
      if (!cv::Rect({0, 0}, size).contains(pixel)) continue;
      sent.color.at<cv::Vec3b>(y, x) = ideal.frame.color_rgb.at<cv::Vec3b>(pixel);
      sent.depth_m.at<float>(y, x) = ideal.frame.depth_m.at<float>(pixel);
      sent.labels.at<std::uint16_t>(y, x) = ideal.labels.at<std::uint16_t>(pixel);
    }
  }
  return sent;
}

v1::DetectRequest RequestOf(const cv::Mat& color, const cv::Mat& depth_m,
                            const CameraIntrinsics& k) {
  const auto width = static_cast<std::uint32_t>(color.cols);
  const auto height = static_cast<std::uint32_t>(color.rows);
  v1::DetectRequest request;
  v1::Frame& frame = *request.mutable_frame();
  *frame.mutable_color() =
      client::MakeColorImage(color.data, width, height, v1::COLOR_ENCODING_RGB8);
  *frame.mutable_depth() = client::MakeDepthImage(depth_m.ptr<float>(), width, height);
  *frame.mutable_intrinsics() = client::MakeIntrinsics(k.fx_px, k.fy_px, k.cx_px, k.cy_px);
  request.mutable_options()->set_return_masks(true);
  request.mutable_options()->set_return_clouds(true);
  request.mutable_options()->mutable_grasps()->set_none(true);
  return request;
}

// How many of the objects have a mask that covers one true label and little else.
int CountRight(const v1::Detections& found, const cv::Mat& labels) {
  int right = 0;
  for (const v1::Object& object : found.objects()) {
    const v1::BoundingBox2D& b = object.mask().bounds();
    const std::vector<std::uint8_t> mask = client::DecodeMask(object.mask());
    std::map<int, int> pixels;
    for (std::size_t i = 0; i < mask.size(); ++i) {
      const auto x = static_cast<int>(b.x() + i % b.width());
      const auto y = static_cast<int>(b.y() + i / b.width());
      if (mask[i] != 0) ++pixels[labels.at<std::uint16_t>(y, x)];
    }
    for (const auto& [label, count] : pixels) {
      if (label == 0) continue;
      const int either =
          cv::countNonZero(labels == label) + static_cast<int>(object.num_pixels()) - count;
      right += count > 0.75 * either ? 1 : 0;
    }
  }
  return right;
}

TEST(Distortion, ObjectsAreWhereTheyAreAndMasksWhereTheyWereSent) {
  const scenes::LabelledFrame ideal = scenes::MakeFrame(
      scenes::RandomScene("tabletop", 2, {320, 240}), scenes::SensorKind::kIdeal, 1);
  const CameraIntrinsics& k = ideal.frame.intrinsics;
  LensDistortion distortion;
  std::copy(kBarrel.begin(), kBarrel.end(), distortion.coefficients.begin());
  const SentFrame sent = Distorted(ideal, Lens(k, distortion, ideal.labels.size()));

  Loopback loopback;
  const v1::Detections expected =
      loopback.client.Detect(RequestOf(ideal.frame.color_rgb, ideal.frame.depth_m, k)).detections();
  ASSERT_GE(CountRight(expected, ideal.labels), 3);
  v1::DetectRequest request = RequestOf(sent.color, sent.depth_m, k);
  *request.mutable_frame()->mutable_intrinsics()->mutable_distortion() =
      client::MakeLensDistortion("plumb_bob", kBarrel);
  const v1::Detections found = loopback.client.Detect(request).detections();
  EXPECT_EQ(CountRight(found, sent.labels), CountRight(expected, ideal.labels));

  for (const v1::Object& a : expected.objects()) {
    double nearest_m = 1;
    for (const v1::Object& b : found.objects()) {
      EXPECT_EQ(b.cloud().positions_size(), 3 * static_cast<int>(b.num_pixels()));
      const auto& p = a.centroid();
      const auto& q = b.centroid();
      nearest_m = std::min(nearest_m, std::hypot(p.x() - q.x(), p.y() - q.y(), p.z() - q.z()));
    }
    EXPECT_LT(nearest_m, 0.01) << a.label();
  }
}

TEST(Distortion, WithoutCoefficientsOrAllZeroIsNone) {
  v1::DetectRequest request = TestRequest();
  Loopback loopback(FindOne);
  v1::Detections without = loopback.client.Detect(request).detections();
  without.clear_stage_times();
  for (const v1::LensDistortion& none :
       {client::MakeLensDistortion("plumb_bob", {0, 0, 0, 0, 0}),
        client::MakeLensDistortion("plumb_bob", {}), client::MakeLensDistortion("equidistant", {}),
        client::MakeLensDistortion("", {}), v1::LensDistortion()}) {
    *request.mutable_frame()->mutable_intrinsics()->mutable_distortion() = none;
    v1::Detections with = loopback.client.Detect(request).detections();
    with.clear_stage_times();
    EXPECT_EQ(with.SerializeAsString(), without.SerializeAsString()) << none.ShortDebugString();
  }
}

// Of a barrel what is left of the middle comes from farther left.
TEST(Distortion, RegionsAreInThePixelsThatAreSent) {
  std::mutex mutex;
  RegionOptions seen;
  const auto record = [&](const RgbdFrame& frame, const DetectorOptions& options, Trace* trace,
                          const std::function<bool()>& should_stop) {
    const std::scoped_lock lock(mutex);
    seen = options.region;
    return FindOne(frame, options, trace, should_stop);
  };
  v1::DetectRequest request = TestRequest();
  *request.mutable_frame()->mutable_intrinsics() = client::MakeIntrinsics(20, 20, 15.5, 11.5);
  *request.mutable_frame()->mutable_intrinsics()->mutable_distortion() =
      client::MakeLensDistortion("plumb_bob", {-0.35, 0.05, 0, 0});
  auto& parameters = *request.mutable_options()->mutable_parameters();
  parameters["region.x_px"] = 4;
  parameters["region.width_px"] = 10;
  Loopback(record).client.Detect(request);
  const std::scoped_lock lock(mutex);
  EXPECT_LT(seen.x_px, 4);
  EXPECT_GE(seen.x_px + seen.width_px, 14);
  EXPECT_LE(seen.x_px + seen.width_px, 16);
  EXPECT_EQ(seen.height_px, kHeight);
}

// Of a pincushion the corners of the ideal image are not in the one that is sent.
TEST(Distortion, WhatTheCameraDoesNotSeeIsMarked) {
  std::mutex mutex;
  cv::Mat unseen;
  const auto record = [&](const RgbdFrame& frame, const DetectorOptions& options, Trace* trace,
                          const std::function<bool()>& should_stop) {
    const std::scoped_lock lock(mutex);
    unseen = frame.unseen.clone();
    return FindOne(frame, options, trace, should_stop);
  };
  v1::DetectRequest request = TestRequest();
  *request.mutable_frame()->mutable_intrinsics() = client::MakeIntrinsics(20, 20, 15.5, 11.5);
  *request.mutable_frame()->mutable_intrinsics()->mutable_distortion() =
      client::MakeLensDistortion("plumb_bob", {0.3, 0, 0, 0});
  Loopback(record).client.Detect(request);
  const std::scoped_lock lock(mutex);
  ASSERT_EQ(unseen.size(), cv::Size(kWidth, kHeight));
  EXPECT_NE(unseen.at<std::uint8_t>(0, 0), 0);
  EXPECT_EQ(unseen.at<std::uint8_t>(kHeight / 2, kWidth / 2), 0);
}

void ExpectRefused(const v1::DetectRequest& request, const std::string& error_start,
                   const std::string& error_part) {
  Loopback loopback(FindOne);
  const grpc::Status status = StatusOf([&] { loopback.client.Detect(request); });
  EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_THAT(status.error_message(), StartsWith(error_start));
  EXPECT_THAT(status.error_message(), HasSubstr(error_part));
}

TEST(Distortion, WhatIsNoLensIsRefusedByItsField) {
  const auto request = [](const std::vector<double>& coefficients) {
    v1::DetectRequest with = TestRequest();
    *with.mutable_frame()->mutable_intrinsics()->mutable_distortion() =
        client::MakeLensDistortion("plumb_bob", coefficients);
    return with;
  };
  const std::string field = "frame.intrinsics.distortion.coefficients: ";
  ExpectRefused(request({std::nan(""), 0, 0, 0}), field, "nan is not a finite number");
  ExpectRefused(request({1e300, -1e300, 0, 0}), field, "send rays back or apart");
  ExpectRefused(request({0, 0, 1e9, 0}), field, "tangential");
  ExpectRefused(request({0.1, 0.1}), field, "has 2 numbers");
  ExpectRefused(request(std::vector<double>(12, 0.01)), field, "has 12 numbers");
  v1::DetectRequest unspecified = request({0, 0, 0, 0});
  unspecified.mutable_frame()->mutable_intrinsics()->mutable_distortion()->clear_model();
  ExpectRefused(unspecified, "frame.intrinsics.distortion.model: ", "BROWN_CONRADY");
  EXPECT_THROW(client::MakeLensDistortion("", {0.1, 0, 0, 0}), std::invalid_argument);
}

TEST(Distortion, OfADepthCameraIsTakenOutBeforeItIsRegistered) {
  v1::DetectRequest request = TestRequest();
  v1::Frame& frame = *request.mutable_frame();
  *frame.mutable_depth_intrinsics() = frame.intrinsics();
  *frame.mutable_color_from_depth() = client::MakePose(0, 0, 0, 0, 0, 0, 1);
  *frame.mutable_depth_intrinsics()->mutable_distortion() =
      client::MakeLensDistortion("equidistant", {std::numeric_limits<double>::infinity(), 0, 0, 0});
  ExpectRefused(request, "frame.depth_intrinsics.distortion.coefficients: ", "inf is not");

  // A cushion, so that the corners of colour are beyond what the depth camera sees.
  *frame.mutable_depth_intrinsics() = client::MakeIntrinsics(20, 20, 15.5, 11.5);
  *frame.mutable_intrinsics() = frame.depth_intrinsics();
  *frame.mutable_depth_intrinsics()->mutable_distortion() =
      client::MakeLensDistortion("plumb_bob", {0.4, 0, 0, 0});
  std::mutex mutex;
  cv::Mat depth_m;
  const auto record = [&](const RgbdFrame& given, const DetectorOptions& options, Trace* trace,
                          const std::function<bool()>& should_stop) {
    const std::scoped_lock lock(mutex);
    depth_m = given.depth_m.clone();
    return FindOne(given, options, trace, should_stop);
  };
  Loopback(record).client.Detect(request);
  const std::scoped_lock lock(mutex);
  EXPECT_TRUE(std::isnan(depth_m.at<float>(0, 0)));
  EXPECT_FALSE(std::isnan(depth_m.at<float>(kHeight - 7, kWidth / 2)));
}

}  // namespace
}  // namespace fovea::testing
