#include "client/cli/overlay/overlay.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace fovea::cli {
namespace {

constexpr int kWidth = 160, kHeight = 120;

// One object in the middle, with a grasp.
v1::Detections Found() {
  v1::Detections detections;
  detections.set_width(kWidth);
  detections.set_height(kHeight);
  v1::Object& object = *detections.add_objects();
  object.set_label(1);
  for (v1::BoundingBox2D* bounds :
       {object.mutable_bounding_box(), object.mutable_mask()->mutable_bounds()}) {
    bounds->set_x(70);
    bounds->set_y(50);
    bounds->set_width(20);
    bounds->set_height(20);
  }
  object.mutable_mask()->add_runs(0);
  object.mutable_mask()->add_runs(400);
  object.mutable_oriented_box()->mutable_pose()->mutable_position()->set_z(1);
  object.mutable_oriented_box()->mutable_pose()->mutable_orientation()->set_w(1);
  v1::Grasp& grasp = *object.add_grasps();
  grasp.mutable_tool_center_point()->set_z(1);
  grasp.mutable_approach()->set_z(1);
  grasp.mutable_closing()->set_x(1);
  return detections;
}

v1::CameraIntrinsics Intrinsics() {
  v1::CameraIntrinsics k;
  k.set_fx(100);
  k.set_fy(100);
  k.set_cx(79.5);
  k.set_cy(59.5);
  return k;
}

TEST(Overlay, TintsTheObjectAndDimsTheRest) {
  const cv::Mat color(kHeight, kWidth, CV_8UC3, cv::Scalar(200, 200, 200));
  const cv::Mat picture = DrawOverlay(color, Intrinsics(), Found());
  ASSERT_EQ(picture.size(), cv::Size(2 * kWidth, 2 * kHeight));
  EXPECT_EQ(picture.at<cv::Vec3b>(2, 2), cv::Vec3b(160, 160, 160));
  const cv::Vec3b inside = picture.at<cv::Vec3b>(2 * 66, 2 * 87);
  EXPECT_GT(inside[2], inside[1]) << "the first object is red";
}

TEST(Overlay, ShowsSeedsOnlyWhereAskedFor) {
  const cv::Mat color(kHeight, kWidth, CV_8UC3, cv::Scalar(200, 200, 200));
  v1::Detections found = Found();
  found.add_seeds()->set_x(10);
  found.mutable_seeds(0)->set_y(10);
  EXPECT_EQ(DrawOverlay(color, Intrinsics(), found).at<cv::Vec3b>(20, 20)[1], 160);
  EXPECT_LT(DrawOverlay(color, Intrinsics(), found,
                        {.seeds = true, .saliency = false, .rejected = false, .grasps = false})
                .at<cv::Vec3b>(20, 20)[1],
            60);
}

// Whatever a server sends, the picture is drawn or refused.
TEST(Overlay, EnduresAnswersThatDoNotFit) {
  const cv::Mat color(kHeight, kWidth, CV_8UC3, cv::Scalar(200, 200, 200));
  v1::Detections found = Found();
  found.mutable_objects(0)->mutable_mask()->mutable_bounds()->set_x(150);
  EXPECT_THROW(DrawOverlay(color, Intrinsics(), found), std::runtime_error);
  found = Found();
  const double huge = std::numeric_limits<double>::max(),
               nan = std::numeric_limits<double>::quiet_NaN();
  for (const double number : {huge, -huge, nan, 0.0}) {
    v1::Object& object = *found.mutable_objects(0);
    object.mutable_oriented_box()->mutable_size()->set_x(number);
    object.mutable_shape()->set_kind(v1::SHAPE_KIND_CYLINDER);
    object.mutable_shape()->mutable_center()->set_z(1);
    object.mutable_shape()->mutable_axis()->set_y(number);
    object.mutable_shape()->set_radius_m(number);
    object.mutable_shape()->set_length_m(number);
    object.mutable_grasps(0)->set_opening_m(number);
    object.mutable_grasps(0)->mutable_approach()->set_z(number);
    object.mutable_grasps(0)->set_probability(number);
    EXPECT_EQ(DrawOverlay(color, Intrinsics(), found).cols, 2 * kWidth);
  }
}

}  // namespace
}  // namespace fovea::cli
