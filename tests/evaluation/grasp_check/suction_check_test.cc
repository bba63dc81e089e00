#include "tests/evaluation/grasp_check/suction_check.h"

#include <gmock/gmock.h>

#include <numbers>

#include "tests/support/environment.h"

namespace fovea::evaluation {
namespace {

using Eigen::Vector3d;
using scenes::Body;
using scenes::ShapeKind;

scenes::Scene With(ShapeKind kind, const Vector3d& size_m) {
  scenes::Scene scene;
  Body body;
  body.shape = {kind, size_m, 0, {}};
  body.world_from_body.translation().z() = size_m.z() / 2;
  body.is_object = true;
  scene.bodies = {scenes::Block("table", {0, 0, -0.01}, {1, 1, 0.02}, {}), body};
  return scene;
}

Outcome Check(const scenes::Scene& scene, const Vector3d& at,
              const Vector3d& approach = -Vector3d::UnitZ()) {
  return CheckSuction(PhysicalScene(scene), 1, {}, {at, approach});
}

TEST(SuctionCheck, TakesABoxByItsTop) {
  EXPECT_EQ(Check(With(ShapeKind::kBox, {0.06, 0.1, 0.04}), {0, 0, 0.04}), Outcome::kSuccess);
}

TEST(SuctionCheck, MeetsTheSurfaceNearTheToolCenterPoint) {
  const scenes::Scene scene = With(ShapeKind::kBox, {0.06, 0.1, 0.04});
  EXPECT_EQ(Check(scene, {0, 0, 0.048}), Outcome::kSuccess);
  EXPECT_EQ(Check(scene, {0, 0, 0.055}), Outcome::kNoContact);
  EXPECT_EQ(Check(scene, {0, 0, 0.025}), Outcome::kHitsTarget);
}

TEST(SuctionCheck, LeaksOverAnEdge) {
  const scenes::Scene scene = With(ShapeKind::kBox, {0.06, 0.1, 0.04});
  EXPECT_EQ(Check(scene, {0.014, 0, 0.04}), Outcome::kSuccess);
  EXPECT_EQ(Check(scene, {0.017, 0, 0.04}), Outcome::kNoSeal);
  EXPECT_EQ(Check(With(ShapeKind::kBox, {0.028, 0.1, 0.04}), {0, 0, 0.04}), Outcome::kNoSeal);
}

TEST(SuctionCheck, SealsOnWhatIsCurvedLittle) {
  // The lip of 15 mm radius is level on a ball. 12 / m and 1.5 mm allow 1.35 + 1.5 mm in its
  // middle: a ball whose cap is that high has a radius of 41 mm.
  EXPECT_EQ(Check(With(ShapeKind::kSphere, {0.09, 0.09, 0.09}), {0, 0, 0.09}), Outcome::kSuccess);
  EXPECT_EQ(Check(With(ShapeKind::kSphere, {0.07, 0.07, 0.07}), {0, 0, 0.07}), Outcome::kNoSeal);
}

TEST(SuctionCheck, FacesTheSurface) {
  const scenes::Scene scene = With(ShapeKind::kBox, {0.1, 0.1, 0.1});
  const auto tilted = [](double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return Vector3d(std::sin(angle), 0, -std::cos(angle));
  };
  EXPECT_EQ(Check(scene, {0, 0, 0.1}, tilted(12)), Outcome::kSuccess);
  EXPECT_EQ(Check(scene, {0, 0, 0.1}, tilted(18)), Outcome::kTilted);
  EXPECT_EQ(Check(scene, {0.05, 0, 0.05}, -Vector3d::UnitX()), Outcome::kSuccess);
}

TEST(SuctionCheck, IsStoppedByWhatHangsAbove) {
  scenes::Scene scene = With(ShapeKind::kBox, {0.1, 0.1, 0.04});
  // A board over half of the cup.
  scene.bodies.push_back(scenes::Block("board", {0.26, 0, 0.14}, {0.5, 0.5, 0.02}, {}));
  EXPECT_EQ(Check(scene, {0, 0, 0.04}), Outcome::kOtherBodyFirst);
  scene.bodies.back().world_from_body.translation().x() = 0.27;
  EXPECT_EQ(Check(scene, {0, 0, 0.04}), Outcome::kSuccess);
}

// Narrow enough to stand between the rays that look for it.
TEST(SuctionCheck, TellsWhatIsInTheWay) {
  scenes::Scene scene = With(ShapeKind::kBox, {0.1, 0.1, 0.04});
  scene.bodies.push_back(scenes::Block("wire", {0.0037, 0, 0.14}, {0.002, 0.002, 0.02}, {}));
  EXPECT_EQ(Check(scene, {0, 0, 0.04}), Outcome::kHitsFurniture);
  scene.bodies.back().is_object = true;
  EXPECT_EQ(Check(scene, {0, 0, 0.04}), Outcome::kHitsNeighbor);
}

TEST(SuctionCheck, HoldsNearTheMassOnly) {
  const scenes::Scene scene = With(ShapeKind::kBox, {0.3, 0.1, 0.04});
  EXPECT_EQ(Check(scene, {0.039, 0, 0.04}), Outcome::kSuccess);
  EXPECT_EQ(Check(scene, {0.041, 0, 0.04}), Outcome::kTooFarFromTheMass);
}

}  // namespace
}  // namespace fovea::evaluation
