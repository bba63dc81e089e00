#include "client/pcl/clouds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>

namespace fovea::client {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZRGB>;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint32_t kWidth = 8, kHeight = 6;

// A slope before the camera with focal lengths 10 and 11, and one point without depth.
Cloud Slope() {
  Cloud cloud(kWidth, kHeight);
  for (std::uint32_t v = 0; v < kHeight; ++v) {
    for (std::uint32_t u = 0; u < kWidth; ++u) {
      pcl::PointXYZRGB& point = cloud.at(u, v);
      point.z = 1 + 0.1F * static_cast<float>(v);
      point.x = (static_cast<float>(u) - 3.5F) / 10 * point.z;
      point.y = (static_cast<float>(v) - 2.25F) / 11 * point.z;
      point.r = static_cast<std::uint8_t>(u);
      point.g = static_cast<std::uint8_t>(v);
      point.b = 7;
    }
  }
  cloud.at(2, 1).x = cloud.at(2, 1).y = cloud.at(2, 1).z = kNaN;
  cloud.header.stamp = 1'700'000'000'250'000;
  return cloud;
}

TEST(PclClouds, TellTheirCamera) {
  const v1::CameraIntrinsics k = IntrinsicsOf(Slope());
  EXPECT_NEAR(k.fx(), 10, 1e-4);
  EXPECT_NEAR(k.fy(), 11, 1e-4);
  EXPECT_NEAR(k.cx(), 3.5, 1e-4);
  EXPECT_NEAR(k.cy(), 2.25, 1e-4);

  Cloud bent = Slope();
  bent.at(0, 0).x += 1;
  EXPECT_THROW(IntrinsicsOf(bent), std::invalid_argument);
  Cloud empty = Slope();
  for (auto& point : empty) point.z = 0;
  EXPECT_THROW(IntrinsicsOf(empty), std::invalid_argument);
  Cloud loose = Slope();
  loose.width = static_cast<std::uint32_t>(loose.size());
  loose.height = 1;
  EXPECT_THROW(IntrinsicsOf(loose), std::invalid_argument);
}

TEST(PclClouds, TellTheirCameraInSpiteOfPointsThatAreNotFinite) {
  Cloud cloud = Slope();
  cloud.at(5, 5).x = kNaN;
  cloud.at(6, 5).y = std::numeric_limits<float>::infinity();
  cloud.at(7, 5).z = std::numeric_limits<float>::infinity();
  const v1::CameraIntrinsics k = IntrinsicsOf(cloud);
  EXPECT_NEAR(k.fx(), 10, 1e-4);
  EXPECT_NEAR(k.cy(), 2.25, 1e-4);
  float depth_m = 0;  // of a point whose x is not known
  std::memcpy(&depth_m, ToFrame(cloud, k).depth().data().data() + 4 * (std::size_t{kWidth} * 5 + 5),
              4);
  EXPECT_TRUE(std::isnan(depth_m));
}

TEST(PclClouds, SayWhyTheyTellNoCamera) {
  const auto expect = [](const Cloud& cloud, const char* why) {
    EXPECT_THAT([&] { IntrinsicsOf(cloud); }, ThrowsMessage<std::invalid_argument>(HasSubstr(why)))
        << why;
  };
  Cloud mirrored = Slope();
  for (auto& point : mirrored) point.x = -point.x;
  expect(mirrored, "mirrored or turned: its points must have x right, y down, z forward");
  Cloud of_the_body = Slope();  // x forward, y left, z up
  for (auto& point : of_the_body) {
    std::tie(point.x, point.y, point.z) = std::tuple(point.z, -point.x, -point.y);
  }
  expect(of_the_body, "no pinhole camera took this cloud");
  expect(of_the_body, "x right, y down, z forward");
  Cloud one_row = Slope();
  for (std::size_t i = kWidth; i < one_row.size(); ++i) one_row[i].z = kNaN;
  expect(one_row, "too few points");
  Cloud one_column = Slope();
  for (std::size_t i = 0; i < one_column.size(); ++i) {
    if (i % kWidth != 4) one_column[i].z = kNaN;
  }
  expect(one_column, "too few points");
}

TEST(PclClouds, BecomeFrames) {
  const v1::Frame frame = ToFrame(Slope(), IntrinsicsOf(Slope()));
  EXPECT_EQ(frame.color().width(), kWidth);
  EXPECT_EQ(frame.color().data().substr(3 * (std::size_t{kWidth} * 2 + 5), 3),
            std::string("\x05\x02\x07", 3));
  EXPECT_EQ(frame.depth().encoding(), v1::DEPTH_ENCODING_32FC1);
  float depth[kWidth * kHeight];
  ASSERT_EQ(frame.depth().data().size(), sizeof depth);
  std::memcpy(depth, frame.depth().data().data(), sizeof depth);
  EXPECT_FLOAT_EQ(depth[2 * kWidth + 5], 1.2F);
  EXPECT_TRUE(std::isnan(depth[kWidth + 2]));
  EXPECT_EQ(frame.captured_at().seconds(), 1'700'000'000);
  EXPECT_EQ(frame.captured_at().nanos(), 250'000'000);
}

TEST(PclClouds, HaveTimesInMicroseconds) {
  const v1::CameraIntrinsics k = IntrinsicsOf(Slope());
  Cloud cloud = Slope();
  cloud.header.stamp = 0;
  EXPECT_FALSE(ToFrame(cloud, k).has_captured_at());
  cloud.header.stamp = 253'402'300'799'999'999;
  EXPECT_EQ(ToFrame(cloud, k).captured_at().seconds(), 253'402'300'799);
  for (const std::uint64_t no_time : {std::uint64_t{253'402'300'800'000'000},
                                      std::uint64_t{1'700'000'000'000'000'000}, ~std::uint64_t{}}) {
    cloud.header.stamp = no_time;
    EXPECT_THAT(
        [&] { ToFrame(cloud, k); },
        ThrowsMessage<std::invalid_argument>(AllOf(
            HasSubstr("header.stamp " + std::to_string(no_time)), HasSubstr("microseconds"))));
  }
}

TEST(PclClouds, NeedMasksForLabelsAndIndices) {
  v1::Detections detections;
  detections.set_width(kWidth);
  detections.set_height(kHeight);
  EXPECT_EQ(Labelled(Slope(), detections).at(3, 1).label, 0U)
      << "without objects, nothing is needed";
  v1::Object& object = *detections.add_objects();
  object.set_label(3);
  const auto names_the_option = ThrowsMessage<std::invalid_argument>(
      AllOf(HasSubstr("object 3 "), HasSubstr("DetectOptions.return_masks")));
  EXPECT_THAT([&] { IndicesOf(object, kWidth); }, names_the_option);
  EXPECT_THAT([&] { Labelled(Slope(), detections); }, names_the_option);
}

TEST(PclClouds, TakeLabelsAndIndices) {
  v1::Detections detections;
  detections.set_width(kWidth);
  detections.set_height(kHeight);
  v1::Object& object = *detections.add_objects();
  object.set_label(3);
  v1::Mask& mask = *object.mutable_mask();
  mask.mutable_bounds()->set_x(2);
  mask.mutable_bounds()->set_y(1);
  mask.mutable_bounds()->set_width(2);
  mask.mutable_bounds()->set_height(2);
  for (const std::uint32_t run : {1, 2, 1}) mask.add_runs(run);
  const pcl::PointIndices indices = IndicesOf(object, kWidth);
  EXPECT_EQ(indices.indices, (pcl::Indices{kWidth + 3, 2 * kWidth + 2}));

  const auto labelled = Labelled(Slope(), detections);
  EXPECT_EQ(labelled.at(3, 1).label, 3U);
  EXPECT_EQ(labelled.at(2, 1).label, 0U);
  EXPECT_EQ(labelled.at(3, 1).r, 3);
  EXPECT_EQ(labelled.at(3, 1).z, Slope().at(3, 1).z);

  mask.mutable_bounds()->set_x(7);
  EXPECT_THROW(IndicesOf(object, kWidth), std::exception);
  mask.mutable_bounds()->set_x(0);
  mask.mutable_bounds()->set_y(4'000'000'000);
  EXPECT_THROW(Labelled(Slope(), detections), std::exception);
  detections.set_width(9);
  EXPECT_THROW(Labelled(Slope(), detections), std::exception);
}

TEST(PclClouds, ComeFromAnswers) {
  v1::PointCloud cloud;
  for (const float x : {1.F, 2.F, 3.F}) cloud.add_positions(x);
  cloud.set_colors("\x0A\x14\x1E");
  const auto points = ToPcl(cloud);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0].y, 2);
  EXPECT_EQ(points[0].b, 30);
  cloud.add_positions(4);
  EXPECT_THROW(ToPcl(cloud), std::runtime_error);

  v1::Pose pose;
  pose.mutable_position()->set_z(5);
  pose.mutable_orientation()->set_z(1);  // half a turn about z
  EXPECT_TRUE((ToEigen(pose) * Eigen::Vector3d(1, 2, 3)).isApprox(Eigen::Vector3d(-1, -2, 8)));
}

}  // namespace
}  // namespace fovea::client
