// Grippers of requests, and those that the operator knows.
#include "server/conversion/robot_grippers.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "server/conversion/gripper.h"
#include "tests/server/detectors.h"
#include "tests/server/frames.h"
#include "tests/server/loopback.h"

namespace fovea::testing {
namespace {

using server::RobotGrippers;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string ErrorOf(const std::vector<std::string>& given) {
  try {
    const RobotGrippers grippers(given);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "valid";
}

TEST(Grippers, OfARequestAreCheckedAndFilledIn) {
  v1::GraspOptions options;
  EXPECT_EQ(server::FromProto(options).size(), 1U);
  v1::Gripper& gripper = *options.add_grippers();
  gripper.mutable_jaw()->set_max_opening_m(0.14);
  gripper.set_max_grasps(3);
  gripper.set_min_probability(0.2);
  options.add_grippers()->mutable_suction();
  const std::vector<Gripper> grippers = server::FromProto(options);
  ASSERT_EQ(grippers.size(), 2U);
  EXPECT_FLOAT_EQ(std::get<JawGripper>(grippers[0].hand).max_opening_m, 0.14F);
  EXPECT_FLOAT_EQ(std::get<JawGripper>(grippers[0].hand).finger_length_m, 0.04F);
  EXPECT_EQ(grippers[0].max_grasps, 3);
  EXPECT_FLOAT_EQ(grippers[0].min_probability, 0.2F);
  EXPECT_FLOAT_EQ(grippers[1].min_probability, 0.5F);
  EXPECT_FLOAT_EQ(std::get<SuctionGripper>(grippers[1].hand).diameter_m, 0.03F);
  EXPECT_FLOAT_EQ(grippers[1].max_tilt_rad, 0.8F);
}

TEST(Grippers, AWrongFieldIsNamed) {
  const auto error_of = [](const std::function<void(v1::Gripper&)>& change) -> std::string {
    v1::GraspOptions options;
    change(*options.add_grippers());
    try {
      server::FromProto(options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "valid";
  };
  EXPECT_THAT(error_of([](auto& g) { g.mutable_jaw()->set_max_opening_m(-1); }),
              StartsWith("options.grasps.grippers[0].jaw.max_opening_m: "));
  EXPECT_THAT(error_of([](auto& g) { g.mutable_jaw()->set_finger_width_m(1e-300); }),
              StartsWith("options.grasps.grippers[0].jaw.finger_width_m: "));
  EXPECT_THAT(error_of([](auto& g) { g.mutable_jaw()->set_friction(NAN); }),
              StartsWith("options.grasps.grippers[0].jaw.friction: "));
  EXPECT_THAT(error_of([](auto& g) { g.mutable_suction()->set_diameter_m(1); }),
              StartsWith("options.grasps.grippers[0].suction.diameter_m: "));
  EXPECT_THAT(
      error_of([](auto& g) { g.mutable_approach()->set_x(2); }),
      StartsWith("options.grasps.grippers[0].approach: must be a unit vector; its length is 2"));
  EXPECT_THAT(error_of([](auto& g) { g.set_max_tilt_rad(2); }),
              StartsWith("options.grasps.grippers[0].max_tilt_rad: "));
  EXPECT_THAT(error_of([](auto& g) { g.set_max_grasps(21); }),
              StartsWith("options.grasps.grippers[0].max_grasps: "));
  EXPECT_THAT(error_of([](auto& g) { g.set_min_probability(1.5); }),
              StartsWith("options.grasps.grippers[0].min_probability: "));
  EXPECT_THAT(error_of([](auto& g) { g.set_min_probability(NAN); }),
              StartsWith("options.grasps.grippers[0].min_probability: "));
}

TEST(RobotGrippers, StandInWhereTheRequestSaysNothing) {
  const RobotGrippers grippers({R"(arm={"name": "wide", "jaw": {"max_opening_m": 0.14}})",
                                R"(arm={"suction": {}})", R"(*={"jaw": {"maxOpeningM": 0.06}})"});
  const std::vector<Gripper> requested(1);
  const std::vector<Gripper> of_arm = grippers.For("arm", {}, requested);
  ASSERT_EQ(of_arm.size(), 2U);
  EXPECT_EQ(of_arm[0].name, "wide");
  EXPECT_TRUE(std::holds_alternative<SuctionGripper>(of_arm[1].hand));
  const std::vector<Gripper> of_other = grippers.For("cart", {}, requested);
  ASSERT_EQ(of_other.size(), 1U);
  EXPECT_FLOAT_EQ(std::get<JawGripper>(of_other[0].hand).max_opening_m, 0.06F);
  EXPECT_EQ(grippers.SourceFor("cart", {}), v1::GRIPPER_SOURCE_SERVER);
  EXPECT_EQ(RobotGrippers().SourceFor("cart", {}), v1::GRIPPER_SOURCE_DEFAULT);

  v1::GraspOptions none, own;
  none.set_none(true);
  EXPECT_TRUE(grippers.For("arm", none, {}).empty());
  own.add_grippers()->set_name("own");
  EXPECT_EQ(grippers.For("arm", own, server::FromProto(own)).front().name, "own");
  EXPECT_EQ(grippers.SourceFor("arm", own), v1::GRIPPER_SOURCE_REQUEST);
}

TEST(RobotGrippers, NameWhatIsWrong) {
  EXPECT_EQ(ErrorOf({}), "valid");
  EXPECT_THAT(ErrorOf({"arm"}), HasSubstr("--gripper: \"arm\": is not ROBOT={"));
  EXPECT_THAT(ErrorOf({"={}"}), HasSubstr("is not ROBOT={"));
  EXPECT_THAT(ErrorOf({"arm={"}), HasSubstr("is no fovea.v1.Gripper in JSON"));
  EXPECT_THAT(ErrorOf({R"(arm={"jaw": {"opening": 1}})"}), HasSubstr("opening"));
  EXPECT_THAT(ErrorOf({R"(arm={"jaw": {"max_opening_m": 7}})"}),
              HasSubstr(": grippers[0].jaw.max_opening_m: must be"));
  EXPECT_THAT(ErrorOf(std::vector<std::string>(9, "arm={}")), HasSubstr("at most 8"));
}

TEST(RobotGrippers, AnswersSayWhoseTheyAre) {
  server::ServerOptions options = LoopbackOptions();
  options.grippers = {R"(*={"name": "cup", "suction": {"diameter_m": 0.05}})"};
  std::vector<Gripper> planned_for;
  const Loopback loopback(
      [&](const RgbdFrame& frame, const DetectorOptions& asked, Trace* trace, const auto& stop) {
        planned_for = asked.grippers;
        Detections found = FindOne(frame, asked, trace, stop);
        found.grippers = asked.grippers;
        return found;
      },
      options);
  v1::DetectRequest request = TestRequest();
  const v1::Detections as_configured = loopback.client.Detect(request).detections();
  EXPECT_EQ(as_configured.grippers_source(), v1::GRIPPER_SOURCE_SERVER);
  ASSERT_EQ(as_configured.grippers_size(), 1);
  EXPECT_EQ(as_configured.grippers(0).name(), "cup");
  ASSERT_EQ(planned_for.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<SuctionGripper>(planned_for[0].hand));
  request.mutable_options()->mutable_grasps()->add_grippers()->set_name("own");
  const v1::Detections as_asked = loopback.client.Detect(request).detections();
  EXPECT_EQ(as_asked.grippers_source(), v1::GRIPPER_SOURCE_REQUEST);
  EXPECT_EQ(as_asked.grippers(0).name(), "own");
}

}  // namespace
}  // namespace fovea::testing
