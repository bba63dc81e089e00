// Grasps of simple things on a floor, seen by an ideal camera.
#include "core/grasping/plan_grasps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/shape/things_on_floor.h"

namespace fovea {
namespace {

using scenes::ShapeKind;

Gripper Jaw(float opening_m) {
  JawGripper jaw;
  jaw.max_opening_m = opening_m;
  Gripper gripper;
  gripper.name = "jaw";
  gripper.hand = jaw;
  return gripper;
}

Gripper Cup() {
  Gripper gripper;
  gripper.name = "cup";
  gripper.hand = SuctionGripper{};
  gripper.max_tilt_rad = 0.8F;
  return gripper;
}

std::vector<DetectedObject> Plan(const std::vector<scenes::Body>& things,
                                 const std::vector<Gripper>& grippers, double pitch_deg = 45) {
  ThingsOnFloor scene = CompleteThings(things, pitch_deg);
  Detections& found = scene.detections;
  PlanGrasps({scene.points, found.labels, scene.frame.intrinsics, -found.gravity.direction},
             grippers, found.objects);
  return found.objects;
}

void ExpectReason(const DetectedObject& object, NoGrasp::Reason reason) {
  EXPECT_TRUE(object.grasps.empty());
  ASSERT_EQ(object.no_grasps.size(), 1U);
  EXPECT_EQ(object.no_grasps[0].reason, reason);
}

TEST(PlanGrasps, TakesABoxAcrossItsNarrowerSideFromAbove) {
  const auto objects =
      Plan({Thing(ShapeKind::kBox, {0.14, 0.06, 0.1}, {0, 0}, 0, 0.4)}, {Jaw(0.085F)});
  const DetectedObject& box = objects[0];
  ASSERT_FALSE(box.grasps.empty());
  EXPECT_TRUE(box.no_grasps.empty());
  EXPECT_LE(box.grasps.size(), 5U);
  for (const Grasp& grasp : box.grasps) {
    EXPECT_EQ(grasp.kind, Grasp::Kind::kAcross);
    EXPECT_GT(std::abs(grasp.closing.dot(box.box.rotation.col(1))), std::cos(0.3F));
    EXPECT_GT(grasp.approach.dot(-box.box.rotation.col(2)), 0.999F);
    EXPECT_NEAR(grasp.opening_m, 0.06F, 0.01F);
    EXPECT_FLOAT_EQ(grasp.pre_grasp_opening_m, 0.085F);  // as far as it can
    EXPECT_NEAR(grasp.closing.dot(grasp.approach), 0, 1e-4F);
    EXPECT_GE(grasp.probability, 0.5F);
    EXPECT_LE(grasp.probability, 1);
  }
  for (std::size_t i = 1; i < box.grasps.size(); ++i) {
    EXPECT_LE(box.grasps[i].probability, box.grasps[i - 1].probability);
  }
}

TEST(PlanGrasps, OpensWideWhereThereIsRoom) {
  const scenes::Body box = Thing(ShapeKind::kBox, {0.14, 0.05, 0.1}, {0, 0}, 0);
  const auto between = [&](double gap_m) {
    const double middle_m = 0.025 + gap_m + 0.02;
    return Plan({box, Thing(ShapeKind::kBox, {0.2, 0.04, 0.1}, {0, middle_m}, 0),
                 Thing(ShapeKind::kBox, {0.2, 0.04, 0.1}, {0, -middle_m}, 0)},
                {Jaw(0.12F)}, 60)[0];
  };
  const auto room_of = [](const DetectedObject& object) {
    if (object.grasps.empty()) return -1.0F;  // none of these is right
    return object.grasps[0].pre_grasp_opening_m - object.grasps[0].opening_m;
  };
  EXPECT_NEAR(room_of(between(0.2)), 0.06F, 0.006F);
  // 55 mm: a finger of 10, 20 of clearance, 25 to open.
  EXPECT_NEAR(room_of(between(0.055)), 0.05F, 0.012F);
  EXPECT_NEAR(room_of(between(0.03)), 0.02F, 0.005F);
}

TEST(PlanGrasps, SaysWhatIsTooWide) {
  const auto objects = Plan({Thing(ShapeKind::kBox, {0.16, 0.16, 0.1}, {0, 0}, 0)}, {Jaw(0.085F)});
  ExpectReason(objects[0], NoGrasp::Reason::kTooWide);
}

TEST(PlanGrasps, BetweenNeighborsOneWayIsLeft) {
  // Beside it on both sides there is no room for a finger: across the other sides there is.
  const auto objects = Plan({Thing(ShapeKind::kBox, {0.06, 0.05, 0.1}, {0, 0}, 0),
                             Thing(ShapeKind::kBox, {0.06, 0.05, 0.1}, {0, 0.065}, 0),
                             Thing(ShapeKind::kBox, {0.06, 0.05, 0.1}, {0, -0.065}, 0)},
                            {Jaw(0.085F)});
  ASSERT_FALSE(objects[0].grasps.empty());
  for (const Grasp& grasp : objects[0].grasps) EXPECT_GT(std::abs(grasp.closing.x()), 0.85F);
}

TEST(PlanGrasps, ABallIsTakenBelowItsUpperQuarter) {
  const auto objects =
      Plan({Thing(ShapeKind::kSphere, {0.07, 0.07, 0.07}, {0, 0}, 0)}, {Jaw(0.14F)});
  ASSERT_FALSE(objects[0].grasps.empty());
  const DetectedObject& ball = objects[0];
  const float below_middle =
      (ball.box.center - ball.grasps[0].tool_center_point).dot(ball.box.rotation.col(2));
  EXPECT_GT(below_middle, -0.016F);  // where its sides are as steep as friction asks
}

TEST(PlanGrasps, ABallWiderThanTheHandIsNotTakenByItsTop) {
  // Where 85 mm reach around it, its sides are steeper than friction holds.
  const auto objects =
      Plan({Thing(ShapeKind::kSphere, {0.11, 0.11, 0.11}, {0, 0}, 0)}, {Jaw(0.085F)});
  EXPECT_TRUE(objects[0].grasps.empty());
}

TEST(PlanGrasps, ABowlWiderThanTheHandIsTakenByItsRim) {
  const auto objects =
      Plan({Thing(ShapeKind::kBowl, {0.16, 0.16, 0.055}, {0, 0}, 0, 0, 0.005)}, {Jaw(0.085F)});
  const DetectedObject& bowl = objects[0];
  ASSERT_FALSE(bowl.grasps.empty());
  const Grasp& grasp = bowl.grasps[0];
  EXPECT_EQ(grasp.kind, Grasp::Kind::kRim);
  const Eigen::Vector3f from_middle =
      bowl.box.rotation.transpose() * (grasp.tool_center_point - bowl.box.center);
  EXPECT_NEAR(from_middle.head<2>().norm(), 0.0775F, 0.006F);  // the middle of the wall
  EXPECT_LT(from_middle.z(), 0.0275F - 0.003F);
}

TEST(PlanGrasps, ACupFollowsALargeBallTowardsItsMiddle) {
  const auto objects = Plan({Thing(ShapeKind::kSphere, {0.12, 0.12, 0.12}, {0, 0}, 0)}, {Cup()});
  ASSERT_FALSE(objects[0].grasps.empty());
  const Grasp& grasp = objects[0].grasps[0];
  const Eigen::Vector3f to_middle = objects[0].box.center - grasp.tool_center_point;
  EXPECT_GT(grasp.approach.dot(to_middle.normalized()), 0.999F);
}

TEST(PlanGrasps, ACupLiesOnTheFlatTopOfABoxAndOnNothingUneven) {
  const auto objects = Plan({Thing(ShapeKind::kBox, {0.12, 0.1, 0.08}, {-0.1, 0}, 0),
                             Thing(ShapeKind::kSphere, {0.05, 0.05, 0.05}, {0.1, 0}, 0)},
                            {Cup()});
  ASSERT_FALSE(objects[0].grasps.empty());
  const Grasp& grasp = objects[0].grasps[0];
  EXPECT_EQ(grasp.kind, Grasp::Kind::kSuction);
  EXPECT_EQ(grasp.opening_m, 0);
  EXPECT_GE(grasp.usable_diameter_m, 0.03F);
  EXPECT_LT(grasp.unevenness_m, 0.002F);
  EXPECT_TRUE(objects[1].grasps.empty());
  EXPECT_EQ(objects[1].no_grasps.size(), 1U);
}

TEST(PlanGrasps, AnswersForEachGripperInTheirOrder) {
  const std::vector<Gripper> grippers = {Jaw(0.03F), Jaw(0.1F), Cup()};
  const auto objects = Plan({Thing(ShapeKind::kBox, {0.14, 0.08, 0.1}, {0, 0}, 0)}, grippers);
  ASSERT_EQ(objects[0].no_grasps.size(), 1U);
  EXPECT_EQ(objects[0].no_grasps[0].gripper, 0U);
  std::vector<bool> has_grasp(grippers.size());
  for (std::size_t i = 0; i < objects[0].grasps.size(); ++i) {
    has_grasp[objects[0].grasps[i].gripper] = true;
    if (i > 0) {
      EXPECT_GE(objects[0].grasps[i].gripper, objects[0].grasps[i - 1].gripper);
    }
  }
  EXPECT_EQ(has_grasp, (std::vector<bool>{false, true, true}));
}

TEST(PlanGrasps, FarFromStraightDownItComesFromTheSideToo) {
  Gripper jaw = Jaw(0.085F);
  jaw.max_tilt_rad = 1.5F;
  jaw.max_grasps = 20;
  const auto objects = Plan({Thing(ShapeKind::kCylinder, {0.06, 0.06, 0.2}, {0, 0}, 0)}, {jaw}, 20);
  const auto& grasps = objects[0].grasps;
  EXPECT_TRUE(std::any_of(grasps.begin(), grasps.end(),
                          [](const Grasp& g) { return g.kind == Grasp::Kind::kSide; }));
}

TEST(PlanGrasps, NothingComesThroughWhatTheThingStandsOn) {
  const scenes::Body box = Thing(ShapeKind::kBox, {0.12, 0.06, 0.15}, {0, 0}, 0, 0.4);
  const Eigen::Vector3f up = Plan({box}, {})[0].box.rotation.col(2);
  Gripper jaw = Jaw(0.085F), cup = Cup();
  for (Gripper* gripper : {&jaw, &cup}) {
    gripper->approach = up;
    gripper->min_probability = 0;
  }
  ExpectReason(Plan({box}, {jaw})[0], NoGrasp::Reason::kTooLow);
  ExpectReason(Plan({box}, {cup})[0], NoGrasp::Reason::kTooLow);
}

TEST(PlanGrasps, NoneIsTiltedFurtherThanItMay) {
  const scenes::Body can = Thing(ShapeKind::kCylinder, {0.06, 0.06, 0.2}, {0, 0}, 0);
  const scenes::Body box = Thing(ShapeKind::kBox, {0.12, 0.07, 0.15}, {0.2, 0}, 0, 0.4);
  for (Gripper gripper : {Jaw(0.085F), Cup()}) {
    gripper.max_grasps = 20;
    gripper.min_probability = 0;
    for (const float tilt_rad : {0.35F, 1.3F, 1.4F, 1.5F, std::numbers::pi_v<float> / 2}) {
      gripper.max_tilt_rad = tilt_rad;
      float farthest_rad = 0;
      for (const DetectedObject& object : Plan({can, box}, {gripper}, 20)) {
        for (const Grasp& grasp : object.grasps) {
          const float cosine = grasp.approach.dot(-object.box.rotation.col(2));
          farthest_rad = std::max(farthest_rad, std::acos(std::clamp(cosine, -1.0F, 1.0F)));
        }
      }
      EXPECT_LE(farthest_rad, tilt_rad + 1e-3F) << gripper.name;
      // Both are taken at their sides as well, by cups, which stand across these, at pi / 2 alone.
      const bool is_level = tilt_rad > (gripper.name == "jaw" ? 1.35F : 1.55F);
      EXPECT_EQ(farthest_rad > 1.2F, is_level) << gripper.name << " " << tilt_rad;
    }
  }
}

TEST(PlanGrasps, OpensNoWiderThanItSaysWhereverItsCellsEnd) {
  Gripper jaw = Jaw(0.2F);
  jaw.max_grasps = 20;
  // Cells of the hand's grid grow with the object.
  for (const double length_m : {0.1, 0.9}) {
    const auto objects =
        Plan({Thing(ShapeKind::kBox, {length_m, 0.05, 0.1}, {0, 0}, 0)}, {jaw}, 60);
    ASSERT_FALSE(objects[0].grasps.empty()) << length_m;
    for (const Grasp& grasp : objects[0].grasps) {
      EXPECT_LE(grasp.pre_grasp_opening_m, grasp.opening_m + 0.0701F) << length_m;
    }
  }
}

// Highest of the object over the tool centre point of a grasp from above, where the hand starts.
float AbovePreGrasp(const DetectedObject& object, const Grasp& grasp) {
  const Eigen::Vector3f start =
      grasp.tool_center_point - grasp.approach * grasp.pre_grasp_distance_m;
  const Eigen::Vector3f up = object.box.rotation.col(2);
  return up.dot(object.box.center - start) + object.box.size_m.z() / 2;
}

TEST(PlanGrasps, StartsAboveTheObjectHoweverLongTheFingers) {
  Gripper jaw = Jaw(0.085F);
  std::get<JawGripper>(jaw.hand).finger_length_m = 0.2F;
  jaw.max_grasps = 20;
  jaw.min_probability = 0.01F;
  const auto objects = Plan({Thing(ShapeKind::kBox, {0.06, 0.05, 0.25}, {0, 0}, 0)}, {jaw});
  ASSERT_FALSE(objects[0].grasps.empty());
  float deepest_m = 0;
  for (const Grasp& grasp : objects[0].grasps) {
    EXPECT_LT(AbovePreGrasp(objects[0], grasp), -0.01F);
    deepest_m = std::max(deepest_m, grasp.pre_grasp_distance_m);
  }
  EXPECT_GT(deepest_m, 0.15F);
}

TEST(PlanGrasps, StartsOutOfWhatIsHollow) {
  const auto objects =
      Plan({Thing(ShapeKind::kCup, {0.16, 0.16, 0.16}, {0, 0}, 0, 0, 0.004)}, {Cup()}, 65);
  ASSERT_TRUE(objects[0].shape.hollow);
  ASSERT_FALSE(objects[0].grasps.empty());
  for (const Grasp& grasp : objects[0].grasps) {
    EXPECT_LT(AbovePreGrasp(objects[0], grasp), -0.01F);
    EXPECT_GT(grasp.pre_grasp_distance_m, 0.15F);
  }
}

TEST(PlanGrasps, WhoAllowsLessLikelyGraspsGetsMore) {
  Gripper careful = Jaw(0.085F), bold = Jaw(0.085F);
  careful.max_grasps = bold.max_grasps = 20;
  careful.min_probability = 0.9F;
  bold.min_probability = 0.05F;
  // Wider than the hand, which holds it above its middle, where it slopes nearly too much.
  const auto objects =
      Plan({Thing(ShapeKind::kSphere, {0.089, 0.089, 0.089}, {0, 0}, 0)}, {careful, bold});
  int num_careful = 0, num_bold = 0, num_unlikely = 0;
  for (const Grasp& grasp : objects[0].grasps) {
    (grasp.gripper == 0 ? num_careful : num_bold) += 1;
    EXPECT_GE(grasp.probability, grasp.gripper == 0 ? 0.9F : 0.05F);
    num_unlikely += grasp.probability < 0.5F ? 1 : 0;
  }
  EXPECT_GT(num_bold, num_careful);
  EXPECT_GT(num_unlikely, 0);
}

TEST(PlanGrasps, PlansNothingWhereNoneAsks) {
  const auto objects = Plan({Thing(ShapeKind::kBox, {0.1, 0.06, 0.1}, {0, 0}, 0)}, {});
  EXPECT_TRUE(objects[0].grasps.empty());
  EXPECT_TRUE(objects[0].no_grasps.empty());
}

}  // namespace
}  // namespace fovea
