#include "tests/evaluation/object_figures/box_honesty.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/evaluation/object_figures/true_box.h"

namespace fovea::evaluation {
namespace {

scenes::Body Upright(scenes::ShapeKind kind) {
  scenes::Body body;
  body.shape.kind = kind;
  body.shape.size_m = {0.2, 0.1, 0.08};
  if (kind != scenes::ShapeKind::kBox) body.shape.size_m.setConstant(0.1);
  body.world_from_body.translation() = Eigen::Vector3d(1, 2, 0.04);
  return body;
}

// In the world's frame, 10 mm longer than it is and 6 mm too far along y.
DetectedObject Answer(const scenes::Body& body) {
  DetectedObject answer;
  answer.box = TrueBox(body);
  answer.box.size_m.x() += 0.01F;
  answer.box.center += 0.006F * answer.box.rotation.col(1);
  answer.uncertainty = BoxUncertainty{};
  answer.uncertainty->size_sigma_m.setConstant(0.008F);
  const Eigen::Vector4f variances(1e-6F, 16e-6F, 1e-6F, 1e-4F);
  answer.uncertainty->pose_covariance = variances.asDiagonal();
  return answer;
}

TEST(BoxHonesty, ComparesErrorsWithWhatIsSaid) {
  const scenes::Body box = Upright(scenes::ShapeKind::kBox);
  const UncertainBox compared =
      CompareUncertainBox(box, Answer(box), Eigen::Isometry3d::Identity());
  EXPECT_NEAR(compared[0]->error, 0.01, 1e-6);
  EXPECT_NEAR(compared[0]->sigma, 0.008, 1e-6);
  EXPECT_FALSE(compared[0]->IsWithin(1));
  EXPECT_TRUE(compared[0]->IsWithin(2));
  EXPECT_TRUE(compared[1]->IsWithin(1));
  EXPECT_NEAR(std::abs(compared[4]->error), 0.006, 1e-6);
  EXPECT_NEAR(compared[4]->sigma, 0.004, 1e-6);
  EXPECT_NEAR(compared[6]->error, 0, 1e-3);
  EXPECT_NEAR(compared[6]->sigma, 0.01, 1e-6);
}

TEST(BoxHonesty, WhatIsRoundHasNoTurn) {
  const scenes::Body ball = Upright(scenes::ShapeKind::kSphere);
  EXPECT_FALSE(CompareUncertainBox(ball, Answer(ball), Eigen::Isometry3d::Identity())[6]);
  DetectedObject unsure = Answer(ball);
  unsure.uncertainty.reset();
  EXPECT_FALSE(CompareUncertainBox(ball, unsure, Eigen::Isometry3d::Identity())[0]);
}

TEST(BoxHonesty, CountsWhatIsWithinOneAndTwo) {
  std::vector<UncertainBox> boxes(4);
  boxes[0][2] = {0.5, 1};
  boxes[1][2] = {-1.5, 1};
  boxes[2][2] = {-3, 1};
  const std::vector<Honesty> honesties = HonestyOf(boxes);
  ASSERT_EQ(honesties.size(), 1U);
  EXPECT_EQ(honesties[0].name, "height");
  EXPECT_EQ(honesties[0].count, 3U);
  EXPECT_NEAR(honesties[0].within_one, 1.0 / 3, 1e-9);
  EXPECT_NEAR(honesties[0].within_two, 2.0 / 3, 1e-9);
  EXPECT_NEAR(honesties[0].median_error, 1.5, 1e-9);
}

}  // namespace
}  // namespace fovea::evaluation
