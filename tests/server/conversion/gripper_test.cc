#include "server/conversion/gripper.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace fovea::testing {
namespace {

constexpr double kPi = std::numbers::pi;

// Sends it, and again what came back; that must be the same. Returns what came back.
v1::Gripper SentTwice(const v1::Gripper& gripper) {
  v1::GraspOptions options;
  *options.add_grippers() = gripper;
  const v1::Gripper once = server::ToProto(server::FromProto(options).at(0));
  *options.mutable_grippers(0) = once;
  const v1::Gripper twice = server::ToProto(server::FromProto(options).at(0));
  EXPECT_EQ(once.DebugString(), twice.DebugString());
  return once;
}

v1::Gripper Jaw(double length_m, double width_m, double thickness_m, double friction) {
  v1::Gripper gripper;
  v1::JawGripper& jaw = *gripper.mutable_jaw();
  jaw.set_max_opening_m(length_m);
  jaw.set_finger_length_m(length_m);
  jaw.set_finger_width_m(width_m);
  jaw.set_finger_thickness_m(thickness_m);
  jaw.mutable_palm_size()->set_y(length_m);
  jaw.set_friction(friction);
  return gripper;
}

v1::Gripper Suction(double diameter_m, double curvature_per_m) {
  v1::Gripper gripper;
  gripper.mutable_suction()->set_diameter_m(diameter_m);
  gripper.mutable_suction()->set_max_curvature_per_m(curvature_per_m);
  return gripper;
}

TEST(Grippers, AreTakenAgainAsTheyCameBackAtEachLimit) {
  v1::Gripper most = Jaw(1, 0.5, 0.2, 2);
  most.set_max_tilt_rad(kPi / 2);
  most.set_max_grasps(20);
  most.set_min_probability(1);
  most.mutable_approach()->set_x(0.6004);
  most.mutable_approach()->set_z(0.8006);
  EXPECT_NEAR(SentTwice(most).max_tilt_rad(), kPi / 2, 1e-7);
  v1::Gripper least = Jaw(1e-4, 1e-4, 1e-4, 1e-60);
  least.set_max_tilt_rad(0);
  least.set_max_grasps(1);
  least.set_min_probability(0);
  EXPECT_LT(SentTwice(least).jaw().friction(), 1e-30);
  EXPECT_NEAR(SentTwice(Suction(0.3, 1000)).suction().diameter_m(), 0.3, 1e-7);
  EXPECT_LT(SentTwice(Suction(1e-4, 1e-60)).suction().max_curvature_per_m(), 1e-30);
  EXPECT_NEAR(SentTwice({}).jaw().max_opening_m(), 0.085, 1e-7);
}

TEST(Grippers, ComeBackWithTheWholePalm) {
  const v1::Vector3 usual = SentTwice({}).jaw().palm_size();
  EXPECT_NEAR(usual.x(), 0.085 + 2 * 0.01, 1e-7);
  EXPECT_NEAR(usual.y(), 0.04, 1e-7);
  EXPECT_NEAR(usual.z(), 0.04, 1e-7);
  v1::Gripper wide = Jaw(0.14, 0.02, 0.015, 0.5);
  EXPECT_NEAR(SentTwice(wide).jaw().palm_size().x(), 0.14 + 2 * 0.015, 1e-7);
  wide.mutable_jaw()->mutable_palm_size()->set_x(0.06);
  EXPECT_NEAR(SentTwice(wide).jaw().palm_size().x(), 0.06, 1e-7);
  EXPECT_NEAR(SentTwice(wide).jaw().palm_size().y(), 0.14, 1e-7);
}

TEST(Grippers, AreRefusedBeyondTheirLimits) {
  v1::Gripper tilted;
  tilted.set_max_tilt_rad(kPi / 2 + 1e-6);
  for (const v1::Gripper& wrong :
       {tilted, Suction(0.300001, 0), Suction(9.9e-5, 0), Suction(1e300, 0), Suction(0.03, 1000.1),
        Jaw(1.000001, 0, 0, 0), Jaw(0, 0, 0.200001, 0), Jaw(0, 0, 0, 2.0001), Jaw(NAN, 0, 0, 0)}) {
    EXPECT_THROW(SentTwice(wrong), std::invalid_argument) << wrong.DebugString();
  }
}

}  // namespace
}  // namespace fovea::testing
