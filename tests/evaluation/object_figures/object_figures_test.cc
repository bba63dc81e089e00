#include <gmock/gmock.h>

#include <numbers>

#include "tests/evaluation/generated/true_class.h"
#include "tests/evaluation/object_figures/box_errors.h"
#include "tests/evaluation/object_figures/true_supports.h"
#include "tests/support/compound_parts.h"
#include "tests/support/random_objects.h"

namespace fovea::evaluation {
namespace {

using scenes::Body;
using scenes::ShapeKind;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

Body Object(ShapeKind kind, const Eigen::Vector3d& size_m, double yaw_rad = 0,
            const Eigen::Vector2d& at = {0, 0}, double height_m = 0) {
  Body body;
  body.shape = {kind, size_m, kind == ShapeKind::kCup ? 0.005 : 0, {}};
  body.is_object = true;
  Rest(body, at, height_m, yaw_rad);
  return body;
}

Body Lying(Body body) {
  body.world_from_body.linear() =
      Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitY()).toRotationMatrix();
  Rest(body, {0, 0}, 0, 0);
  return body;
}

TEST(TrueBox, HasTheSizesOfTheSolid) {
  const OrientedBox box = TrueBox(Object(ShapeKind::kBox, {0.05, 0.2, 0.1}, 0.4, {1, 2}, 0.7));
  EXPECT_TRUE(box.size_m.isApprox(Eigen::Vector3f(0.2F, 0.05F, 0.1F), 1e-4F));
  EXPECT_TRUE(box.center.isApprox(Eigen::Vector3f(1, 2, 0.75F), 1e-4F));
  // Its long side is the body's y axis.
  EXPECT_NEAR(std::abs(box.rotation(0, 0)), std::sin(0.4), 1e-3);
  const OrientedBox tube = TrueBox(Lying(Object(ShapeKind::kCylinder, {0.06, 0.06, 0.2})));
  EXPECT_TRUE(tube.size_m.isApprox(Eigen::Vector3f(0.2F, 0.06F, 0.06F), 2e-3F));
}

TEST(BoxErrors, AreZeroForTheTruth) {
  const Body body = Object(ShapeKind::kBox, {0.05, 0.2, 0.1}, 0.4);
  const BoxErrors errors = CompareBoxes(body, TrueBox(body));
  EXPECT_NEAR(errors.size_m.norm() + errors.center_m + *errors.yaw_deg, 0, 1e-3);
  EXPECT_NEAR(errors.iou, 1, 1e-6);
}

TEST(BoxErrors, MeasureSizeCenterYawAndOverlap) {
  const Body body = Object(ShapeKind::kBox, {0.2, 0.1, 0.1});
  OrientedBox answer = TrueBox(body);
  answer.size_m.z() = 0.2F;
  answer.center.z() += 0.05F;
  BoxErrors errors = CompareBoxes(body, answer);
  EXPECT_NEAR(errors.size_m.z(), 0.1, 1e-6);
  EXPECT_NEAR(errors.center_m, 0.05, 1e-6);
  EXPECT_NEAR(errors.iou, 0.5, 0.02);
  answer = TrueBox(body);
  answer.center.x() += 0.1F;  // a third is shared
  EXPECT_NEAR(CompareBoxes(body, answer).iou, 1.0 / 3, 0.02);
  answer.rotation = Eigen::AngleAxisf(-0.1F, Eigen::Vector3f::UnitZ()) * answer.rotation;
  EXPECT_NEAR(*CompareBoxes(body, answer).yaw_deg, 5.73, 0.01);
  answer.rotation = Eigen::AngleAxisf(3.14159265F, Eigen::Vector3f::UnitZ()) * answer.rotation;
  EXPECT_NEAR(*CompareBoxes(body, answer).yaw_deg, 5.73, 0.01);
}

TEST(BoxErrors, KnowSymmetries) {
  const Body square = Object(ShapeKind::kBox, {0.1, 0.1, 0.1});
  OrientedBox answer = TrueBox(square);
  answer.rotation = Eigen::AngleAxisf(1.57079633F, Eigen::Vector3f::UnitZ()) * answer.rotation;
  EXPECT_NEAR(*CompareBoxes(square, answer).yaw_deg, 0, 0.01);
  const Body can = Object(ShapeKind::kCylinder, {0.1, 0.1, 0.1});
  answer.rotation = Eigen::AngleAxisf(0.5F, Eigen::Vector3f::UnitZ()) * answer.rotation;
  EXPECT_FALSE(CompareBoxes(can, answer).yaw_deg);
  EXPECT_GT(CompareBoxes(can, answer).iou, 0.98);
}

TEST(TrueClass, AcceptsWhatMayBeSaid) {
  using Kind = Shape::Kind;
  EXPECT_THAT(ClassOf(Object(ShapeKind::kBox, {0.1, 0.1, 0.1})).accepted, ElementsAre(Kind::kBox));
  EXPECT_THAT(ClassOf(Object(ShapeKind::kBox, {0.1, 0.1, 0.02})).accepted,
              ElementsAre(Kind::kFlat, Kind::kBox));
  EXPECT_THAT(ClassOf(Object(ShapeKind::kCup, {0.08, 0.08, 0.1})).accepted,
              ElementsAre(Kind::kRevolution));
  const Body tube = Lying(Object(ShapeKind::kCylinder, {0.06, 0.06, 0.2}));
  EXPECT_EQ(ClassOf(tube).name, "tube");
  EXPECT_THAT(ClassOf(tube).accepted, ElementsAre(Kind::kCylinder));
  EXPECT_FALSE(IsRoundUpright(tube));
}

TEST(TrueClass, CompoundsAreRoundIfAllTheirPartsAre) {
  Body bottle = scenes::Compound(
      "bottle", {scenes::DiskPart(0, 0.15, 0.07), scenes::DiskPart(0.15, 0.2, 0.03)});
  EXPECT_TRUE(IsRoundUpright(bottle));
  EXPECT_FALSE(IsRoundUpright(Lying(bottle)));
  EXPECT_FALSE(IsRoundUpright(
      scenes::Compound("mug", {scenes::VesselPart(0.08, 0.1, 0.005),
                               scenes::BlockPart({0.05, 0, 0.05}, {0.03, 0.01, 0.06})})));
}

TEST(TrueSupports, AreWhatIsDirectlyBelow) {
  scenes::Scene scene;
  scene.bodies = {Object(ShapeKind::kBox, {0.2, 0.2, 0.1}),
                  Object(ShapeKind::kBox, {0.1, 0.1, 0.1}, 0.3, {0.02, 0}, 0.1),
                  Object(ShapeKind::kSphere, {0.05, 0.05, 0.05}, 0, {0.02, 0}, 0.2),
                  Object(ShapeKind::kBox, {0.1, 0.1, 0.1}, 0, {0.15, 0})};  // touches the first
  EXPECT_THAT(TrueSupports(scene),
              ElementsAre(IsEmpty(), ElementsAre(1), ElementsAre(2), IsEmpty()));
}

}  // namespace
}  // namespace fovea::evaluation
