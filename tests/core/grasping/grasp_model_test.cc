#include "core/grasping/grasp_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace fovea {
namespace {

TEST(GraspTree, LooksUpWhatItsQuestionsGive) {
  GraspTree tree;
  tree.terms = {kTermHeight, kTermUnseen, kTermHeight, kTermFlat};
  tree.thresholds = {5, 0.5F, 10, 0.5F};
  for (std::size_t i = 0; i < tree.values.size(); ++i)
    tree.values[i] = static_cast<std::int16_t>(i);
  GraspTerms terms{};
  EXPECT_EQ(tree.Of(terms), 0);
  terms[kTermHeight] = 5;  // not above
  EXPECT_EQ(tree.Of(terms), 0);
  terms[kTermHeight] = 5.5F;
  EXPECT_EQ(tree.Of(terms), 1);
  terms[kTermUnseen] = 1;
  EXPECT_EQ(tree.Of(terms), 3);
  terms[kTermHeight] = 11;
  EXPECT_EQ(tree.Of(terms), 7);
  terms[kTermFlat] = 1;
  EXPECT_EQ(tree.Of(terms), 15);
}

TEST(GraspFunction, AddsThousandthsOfLogOdds) {
  GraspTree tree;
  tree.values.fill(-250);
  const GraspFunction function = {1000, {tree, tree}};
  EXPECT_DOUBLE_EQ(function.LogOdds({}), 0.5);
}

TEST(GraspModel, JudgesManyAsItsFunctionsJudgeEach) {
  constexpr std::uint32_t kSeed = 1;
  std::mt19937 random(kSeed);
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::vector<ScoredGrasp> grasps(150);  // more than at once of each family, and some left
  for (ScoredGrasp& grasp : grasps) {
    grasp.family = static_cast<GraspFamily>(random() % kNumGraspFamilies);
    for (float& term : grasp.terms) term = static_cast<float>(random() % 1000) / 400;
  }
  const GraspModel& model = FittedGraspModel();
  model.SetProbabilities(grasps);
  for (const ScoredGrasp& grasp : grasps) {
    const auto family = static_cast<std::size_t>(grasp.family);
    const double log_odds = model.families[family].LogOdds(grasp.terms);
    EXPECT_FLOAT_EQ(grasp.grasp.probability, static_cast<float>(1 / (1 + std::exp(-log_odds))));
  }
}

// What everybody knows of grasps, summed over the other terms of one that is good.
class FittedGrasp : public ::testing::TestWithParam<GraspFamily> {
 protected:
  double OddsWith(std::size_t term, float value) const {
    ScoredGrasp grasp;
    GraspTerms& terms = grasp.terms;
    terms[kTermDistance] = 0.8F;
    terms[kTermConfidence] = 0.98F;
    terms[kTermUnseen] = 0.5F;
    terms[kTermShapeSure] = 0.95F;
    terms[kTermResidual] = 0.1F;
    terms[kTermHeight] = 9;
    terms[kTermSlender] = 1.3F;
    if (GetParam() == GraspFamily::kSuction) {
      terms[kTermUsable] = 1;
      terms[kTermCovered] = 1;
      terms[kTermTubeGap] = 2;
      terms[kTermPoints] = 2;
      terms[kTermEvenReach] = 2;
    } else {
      terms[kTermOpeningLeft] = terms[kTermClearance] = terms[kTermTipGap] = 2;
      terms[kTermPalmGap] = terms[kTermRoom] = 2;
      terms[kTermContactWidth] = 1;
      terms[kTermContactDepth] = 2.5F;
      terms[kTermWidth] = 5;
    }
    terms[term] = value;
    return FittedGraspModel().families[static_cast<std::size_t>(GetParam())].LogOdds(terms);
  }
};

TEST_P(FittedGrasp, IsLessLikelyWhereLessSpeaksForIt) {
  const bool is_suction = GetParam() == GraspFamily::kSuction;
  const double good = OddsWith(kTermConfidence, 0.98F);
  EXPECT_GT(good, 1);
  EXPECT_LT(OddsWith(kTermSeenThrough, 0.2F), good);
  EXPECT_LT(OddsWith(kTermResidual, 1), good);
  if (is_suction) {
    EXPECT_LT(OddsWith(kTermCovered, 0.3F), good);
    EXPECT_LT(OddsWith(kTermEvenReach, 0.8F), good);
    EXPECT_LT(OddsWith(kTermOffCenter, 3), good);
    EXPECT_LT(OddsWith(kTermDisagrees, 0.9F), good);
  } else {
    EXPECT_LT(OddsWith(kTermSlopeAcross, 0.7F), good);
    EXPECT_LT(OddsWith(kTermSlopeDown, 0.7F), good);
    EXPECT_LT(OddsWith(kTermContactWidth, 0.2F), good);
    EXPECT_LT(OddsWith(kTermContactDepth, 0.4F), good);
    EXPECT_LT(OddsWith(kTermHandBehindOther, 1), good);
    EXPECT_LT(OddsWith(kTermRoom, 0), good);
  }
}

INSTANTIATE_TEST_SUITE_P(Families, FittedGrasp,
                         ::testing::Values(GraspFamily::kAcross, GraspFamily::kSuction),
                         [](const auto& instance) {
                           return instance.param == GraspFamily::kSuction ? "Suction" : "Across";
                         });

}  // namespace
}  // namespace fovea
