// What people are told of frames that are odd and may be right: every mistake in words that name
// the field, and nothing of what cameras send.
#include "server/conversion/frame_notes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "client/images.h"
#include "server/conversion/frame.h"
#include "tests/server/frames.h"

namespace fovea::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr int kCols = 640, kRows = 480;
constexpr std::uint64_t kMaxPixels = 1'000'000;

// A floor from 0.5 to 1.5 m, with a hole.
cv::Mat Floor() {
  cv::Mat depth(kRows, kCols, CV_16UC1);
  depth.forEach<std::uint16_t>([](std::uint16_t& pixel, const int* at) {
    const bool is_hole = at[0] > 200 && at[0] < 300 && at[1] > 200 && at[1] < 400;
    pixel = static_cast<std::uint16_t>(is_hole ? 0 : 1500 - 2 * at[0]);
  });
  return depth;
}

v1::Frame FrameOf(const cv::Mat& depth, const v1::CameraIntrinsics& intrinsics) {
  v1::Frame frame;
  *frame.mutable_color() =
      ColorMessage(v1::COLOR_ENCODING_RGB8, std::string(3UL * kRows * kCols, 'c'), kCols, kRows);
  *frame.mutable_depth() =
      DepthMessage(depth.type() == CV_16UC1 ? v1::DEPTH_ENCODING_16UC1 : v1::DEPTH_ENCODING_32FC1,
                   BytesOf(depth), depth.cols, depth.rows);
  *frame.mutable_intrinsics() = intrinsics;
  return frame;
}

v1::CameraIntrinsics Xtion() { return client::MakeIntrinsics(525, 525, 319.5, 239.5); }

std::vector<std::string> NotesOf(const v1::Frame& frame) {
  std::vector<std::string> notes;
  server::FromProto(frame, kMaxPixels, &notes);
  return notes;
}

std::vector<std::string> NotesOf(double fx, double fy, double cx, double cy) {
  return NotesOf(FrameOf(Floor(), client::MakeIntrinsics(fx, fy, cx, cy)));
}

std::vector<std::string> NotesOf(const cv::Mat& depth) { return NotesOf(FrameOf(depth, Xtion())); }

// What was not measured, as `value`.
cv::Mat FloorWith(std::uint16_t value) {
  cv::Mat depth = Floor();
  depth.setTo(value, depth == 0);
  return depth;
}

TEST(FrameNotes, SaysNothingOfWhatCamerasSend) {
  EXPECT_THAT(NotesOf(Floor()), IsEmpty());
  EXPECT_THAT(NotesOf(460, 460, 347, 256), IsEmpty());  // L515
  EXPECT_THAT(NotesOf(964, 964, 320, 223), IsEmpty());
  EXPECT_THAT(NotesOf(190, 190, 330, 236), IsEmpty());  // 120 degrees
  EXPECT_THAT(NotesOf(460, 614, 320, 240), IsEmpty());  // 16 : 9 made 4 : 3
}

TEST(FrameNotes, IntrinsicsOfAnotherSize) {
  const auto is_far = ElementsAre(AllOf(HasSubstr("frame.intrinsics: cx"),
                                        HasSubstr("far from the middle of the image of 640x480"),
                                        HasSubstr("for which size they are")));
  EXPECT_THAT(NotesOf(262.5, 262.5, 159.5, 119.5), is_far);
  EXPECT_THAT(NotesOf(1050, 1050, 620, 495), is_far);
  EXPECT_THAT(NotesOf(421, 421, 424, 240), is_far);      // of 848x480
  EXPECT_THAT(NotesOf(525, 525, -150, 239), is_far);     // a part, or not
  EXPECT_THAT(NotesOf(525, 319.5, 525, 239.5), is_far);  // in the order of a camera matrix
}

TEST(FrameNotes, CenterThatIsSwapped) {
  EXPECT_THAT(NotesOf(525, 525, 239.5, 319.5),
              ElementsAre(HasSubstr("cx 239.5 and cy 319.5 seem to be swapped")));
  EXPECT_THAT(NotesOf(616, 616, 236.6, 310.3), ElementsAre(HasSubstr("seem to be swapped")));
}

TEST(FrameNotes, FocalLengthsInAnotherUnit) {
  const auto is_odd = ElementsAre(HasSubstr("frame.intrinsics: hardly any camera has fx"));
  EXPECT_THAT(NotesOf(60, 45, 319.5, 239.5), is_odd);  // degrees
  EXPECT_THAT(NotesOf(1e5, 1e5, 319.5, 239.5), is_odd);
}

TEST(FrameNotes, FocalLengthsThatAreNotAlike) {
  EXPECT_THAT(NotesOf(525, 1050, 319.5, 239.5), ElementsAre(HasSubstr("are not alike")));
}

TEST(FrameNotes, IntrinsicsOfTheDepthCamera) {
  v1::Frame frame = FrameOf(Floor()(cv::Rect(0, 0, 320, 240)).clone(), Xtion());
  *frame.mutable_depth_intrinsics() = Xtion();
  *frame.mutable_color_from_depth() = client::MakePose(0, 0, 0, 0, 0, 0, 1);
  EXPECT_THAT(NotesOf(frame), ElementsAre(HasSubstr("frame.depth_intrinsics: cx 319.5")));
}

TEST(FrameNotes, ANumberThatStandsForNothing) {
  EXPECT_THAT(NotesOf(FloorWith(65535)),
              ElementsAre(AllOf(HasSubstr("6 % of the pixels have a depth of exactly 65.535 m"),
                                HasSubstr("send 0"))));
  EXPECT_THAT(NotesOf(FloorWith(4000)), ElementsAre(HasSubstr("exactly 4 m")));
  EXPECT_THAT(NotesOf(FloorWith(1)), ElementsAre(HasSubstr("exactly 0.001 m")));
}

TEST(FrameNotes, NothingMeasuredIsNoNumberInFloats) {
  cv::Mat depth_m;
  Floor().convertTo(depth_m, CV_32FC1, 0.001);
  for (const float none : {0.0F, std::numeric_limits<float>::quiet_NaN(),
                           std::numeric_limits<float>::infinity(), -1.0F}) {
    cv::Mat sent_m = depth_m.clone();
    sent_m.setTo(none, depth_m == 0);
    EXPECT_THAT(NotesOf(sent_m), IsEmpty()) << none;
  }
}

// A wall that a noiseless camera looks at straight, and what stands before it.
TEST(FrameNotes, AFlatSurfaceIsNoNumberForNothing) {
  cv::Mat depth(kRows, kCols, CV_16UC1, cv::Scalar(1000));
  depth(cv::Rect(100, 100, 200, 200)).setTo(850);
  EXPECT_THAT(NotesOf(depth), IsEmpty());
}

TEST(FrameNotes, DepthOf8Bits) {
  cv::Mat depth;
  Floor().convertTo(depth, CV_16UC1, 255.0 / 1500);
  EXPECT_THAT(NotesOf(depth), ElementsAre(HasSubstr("a picture of 8 bits")));
}

TEST(FrameNotes, DepthThatIsTooNear) {
  v1::Frame frame = FrameOf(Floor(), Xtion());
  frame.mutable_depth()->set_unit_m(0.00005);
  EXPECT_THAT(NotesOf(frame),
              ElementsAre(AllOf(HasSubstr("more than half"), HasSubstr("nearer than 0.1 m"),
                                HasSubstr("check the depth unit"))));
  frame.mutable_depth()->set_unit_m(0.0005);
  EXPECT_THAT(NotesOf(frame), IsEmpty());
}

TEST(FrameNotes, MetresInIntegers) {
  cv::Mat depth;
  Floor().convertTo(depth, CV_16UC1, 0.001);  // 1 and 2
  EXPECT_THAT(NotesOf(depth), ElementsAre(HasSubstr("nearer than 0.1 m")));
}

// Camera to a frame whose z axis is up, of a camera that is turned to the left by `yaw_rad` and
// looks down by `pitch_rad`.
Eigen::Quaterniond UprightPose(double yaw_rad, double pitch_rad) {
  Eigen::Matrix3d body_from_optical;
  body_from_optical << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY()) *
         Eigen::Quaterniond(body_from_optical);
}

constexpr double kYaw_rad = 2.4, kPitch_rad = 0.7;

std::string NoteOfPose(double x, double y, double z, double w) {
  v1::Frame frame;
  *frame.mutable_camera_pose() = client::MakePose(1, 2, 0.8, x, y, z, w);
  Detections detections;
  detections.support = SupportSurface{};
  detections.gravity.direction = {0, static_cast<float>(std::cos(kPitch_rad)),
                                  static_cast<float>(std::sin(kPitch_rad))};
  return server::OddCameraPose(frame, detections).value_or("");
}

TEST(FrameNotes, PosesThatHaveAnAxisAlongGravityAreNotDoubted) {
  const Eigen::Quaterniond q = UprightPose(kYaw_rad, kPitch_rad);
  EXPECT_EQ(NoteOfPose(q.x(), q.y(), q.z(), q.w()), "");
  const Eigen::Quaterniond to_y(
      Eigen::AngleAxisd(kPitch_rad, Eigen::Vector3d::UnitX()));  // of a map whose y axis is down
  EXPECT_EQ(NoteOfPose(-to_y.x(), to_y.y(), to_y.z(), to_y.w()), "");
  EXPECT_EQ(NoteOfPose(0, 0, 0, 1), "");  // in the camera's own frame
}

TEST(FrameNotes, PosesInAnotherConvention) {
  const Eigen::Quaterniond q = UprightPose(kYaw_rad, kPitch_rad), back = q.conjugate();
  EXPECT_THAT(NoteOfPose(q.w(), q.x(), q.y(), q.z()), HasSubstr("read as w, x, y, z"));
  EXPECT_THAT(NoteOfPose(back.x(), back.y(), back.z(), back.w()), HasSubstr("inverted"));
  const Eigen::Quaterniond body(Eigen::AngleAxisd(kYaw_rad, Eigen::Vector3d::UnitZ()) *
                                Eigen::AngleAxisd(kPitch_rad, Eigen::Vector3d::UnitY()));
  EXPECT_THAT(NoteOfPose(body.x(), body.y(), body.z(), body.w()), HasSubstr("camera's body"));
}

}  // namespace
}  // namespace fovea::testing
