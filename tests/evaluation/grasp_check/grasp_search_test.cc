#include "tests/evaluation/grasp_check/grasp_search.h"

#include <gtest/gtest.h>

#include "tests/evaluation/grasp_figures/grasp_run.h"
#include "tests/support/environment.h"

namespace fovea::evaluation {
namespace {

using scenes::ShapeKind;

// Alone on a table: by the jaws of 85 and of 140 mm, and by the cup.
std::array<bool, 3> Possible(ShapeKind kind, const Eigen::Vector3d& size_m, double wall_m = 0) {
  scenes::Scene scene;
  scenes::Body body;
  body.shape = {kind, size_m, wall_m, {}};
  body.world_from_body.translation().z() = size_m.z() / 2;
  body.is_object = true;
  scene.bodies = {scenes::Block("table", {0, 0, -0.01}, {1, 1, 0.02}, {}), body};
  const PhysicalScene physical(scene);
  const std::vector<Gripper> grippers = EvaluationGrippers();
  return {IsPossible(physical, 1, grippers[0]), IsPossible(physical, 1, grippers[1]),
          IsPossible(physical, 1, grippers[2])};
}

using Answers = std::array<bool, 3>;

TEST(GraspSearch, FindsWhatThereIs) {
  EXPECT_EQ(Possible(ShapeKind::kBox, {0.07, 0.2, 0.1}), (Answers{true, true, true}));
  EXPECT_EQ(Possible(ShapeKind::kBox, {0.1, 0.2, 0.1}), (Answers{false, true, true}));
  EXPECT_EQ(Possible(ShapeKind::kBox, {0.15, 0.2, 0.1}), (Answers{false, false, true}));
  EXPECT_EQ(Possible(ShapeKind::kSphere, {0.06, 0.06, 0.06}), (Answers{true, true, false}));
  EXPECT_EQ(Possible(ShapeKind::kCup, {0.09, 0.09, 0.1}, 0.005), (Answers{true, true, true}));
  EXPECT_EQ(Possible(ShapeKind::kBowl, {0.18, 0.18, 0.06}, 0.005), (Answers{true, true, true}));
}

}  // namespace
}  // namespace fovea::evaluation
