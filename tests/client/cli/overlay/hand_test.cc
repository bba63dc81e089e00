#include "client/cli/overlay/hand.h"

#include <gtest/gtest.h>

#include <cstddef>

#include "server/conversion/gripper.h"

namespace fovea::cli {
namespace {

v1::Grasp FromAbove(v1::GraspKind kind) {
  v1::Grasp grasp;
  grasp.set_kind(kind);
  grasp.mutable_tool_center_point()->set_z(0.5);
  grasp.mutable_approach()->set_z(1);
  grasp.mutable_closing()->set_x(1);
  grasp.set_opening_m(0.05);
  return grasp;
}

TEST(Hand, HasItsFingersAtTheObjectAndItsPalmBehindThem) {
  v1::Detections detections;
  v1::JawGripper& jaw = *detections.add_grippers()->mutable_jaw();
  jaw.set_max_opening_m(0.1);
  jaw.set_finger_length_m(0.06);
  jaw.set_finger_width_m(0.03);
  jaw.set_finger_thickness_m(0.02);
  const Hand hand = HandOf(FromAbove(v1::GRASP_KIND_ACROSS), detections.grippers());
  ASSERT_EQ(hand.blocks.size(), 3U);
  const Block &left = hand.blocks[0], &palm = hand.blocks[2];
  EXPECT_NEAR(left.center[0] + left.half_axes[0][0], -0.025, 1e-12) << "touches the object";
  EXPECT_NEAR(left.center[2] + left.half_axes[2][2], 0.5, 1e-12) << "the tip";
  EXPECT_NEAR(2 * left.half_axes[1][1], 0.03, 1e-12);
  EXPECT_NEAR(palm.center[2] + palm.half_axes[2][2], 0.44, 1e-12);
  EXPECT_NEAR(2 * palm.half_axes[0][0], 0.14, 1e-12) << "as wide as the fingers at their widest";
  EXPECT_NEAR(hand.back[2], 0.40, 1e-12);
}

TEST(Hand, IsACupWithSuction) {
  v1::Detections detections;
  detections.add_grippers()->mutable_suction()->set_diameter_m(0.04);
  const Hand hand = HandOf(FromAbove(v1::GRASP_KIND_SUCTION), detections.grippers());
  EXPECT_TRUE(hand.blocks.empty());
  ASSERT_FALSE(hand.lines.empty());
  EXPECT_NEAR(cv::norm(hand.lines[0].from - cv::Vec3d(0, 0, 0.5)), 0.02, 1e-12);
  EXPECT_LT(hand.back[2], 0.5);
}

TEST(Hand, OfWhichNothingIsSaidHasTheLengthsOfTheServer) {
  v1::GraspOptions unsaid;
  unsaid.add_grippers()->mutable_jaw();
  unsaid.add_grippers()->mutable_suction();
  v1::Detections said;
  for (const Gripper& each : server::FromProto(unsaid)) {
    *said.add_grippers() = server::ToProto(each);
  }
  v1::Grasp grasp = FromAbove(v1::GRASP_KIND_ACROSS);
  const Hand jaw = HandOf(grasp, said.grippers()), usual_jaw = HandOf(grasp, unsaid.grippers());
  ASSERT_EQ(jaw.blocks.size(), usual_jaw.blocks.size());
  for (std::size_t i = 0; i < jaw.blocks.size(); ++i) {
    for (const int axis : {1, 2}) {
      const cv::Vec3d off = jaw.blocks[i].half_axes[axis] - usual_jaw.blocks[i].half_axes[axis];
      EXPECT_NEAR(cv::norm(off), 0, 1e-12) << i << " " << axis;
    }
  }
  EXPECT_NEAR(jaw.blocks[0].center[0], usual_jaw.blocks[0].center[0], 1e-12) << "thickness";
  grasp = FromAbove(v1::GRASP_KIND_SUCTION);
  grasp.set_gripper_index(1);
  const Hand cup = HandOf(grasp, said.grippers()), usual_cup = HandOf(grasp, unsaid.grippers());
  EXPECT_NEAR(cv::norm(cup.lines[0].from - usual_cup.lines[0].from), 0, 1e-12);
}

// What a server sends need not fit.
TEST(Hand, StandsInWhereTheGripperIsUnknown) {
  v1::Grasp grasp = FromAbove(v1::GRASP_KIND_ACROSS);
  grasp.set_gripper_index(4'000'000'000);
  EXPECT_EQ(HandOf(grasp, {}).blocks.size(), 3U);
}

}  // namespace
}  // namespace fovea::cli
