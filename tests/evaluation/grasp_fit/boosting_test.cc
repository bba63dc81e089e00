#include "tests/evaluation/grasp_fit/boosting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace fovea::evaluation {
namespace {

constexpr unsigned kSeedOfTrials = 11;

GraspTrial Trial(float first, float second, bool succeeds, double weight = 1) {
  GraspTrial trial{{}, weight, succeeds};
  trial.terms[3] = first;
  trial.terms[7] = second;
  return trial;
}

// Succeed where exactly one of two terms is above a half, in nine of ten trials.
std::vector<GraspTrial> OneOfTwo() {
  std::mt19937 random(kSeedOfTrials);
  std::uniform_real_distribution<float> uniform;
  std::vector<GraspTrial> trials;
  for (int i = 0; i < 4000; ++i) {
    const float a = uniform(random), b = uniform(random);
    const bool is_likely = (a > 0.5F) != (b > 0.5F);
    trials.push_back(Trial(a, b, (uniform(random) < 0.9F) == is_likely));
  }
  return trials;
}

double ProbabilityAt(const GraspFunction& function, float first, float second) {
  return 1 / (1 + std::exp(-function.LogOdds(Trial(first, second, false).terms)));
}

TEST(Boost, FindsHowTwoTermsActTogether) {
  SCOPED_TRACE(kSeedOfTrials);
  const GraspFunction function = Boost(OneOfTwo(), {.num_trees = 100, .rate = 0.15});
  EXPECT_NEAR(ProbabilityAt(function, 0.25F, 0.75F), 0.9, 0.06);
  EXPECT_NEAR(ProbabilityAt(function, 0.75F, 0.25F), 0.9, 0.06);
  EXPECT_NEAR(ProbabilityAt(function, 0.25F, 0.25F), 0.1, 0.06);
  EXPECT_NEAR(ProbabilityAt(function, 0.75F, 0.75F), 0.1, 0.06);
}

TEST(Boost, EachTreeMakesTheTrialsLikelier) {
  SCOPED_TRACE(kSeedOfTrials);
  const std::vector<GraspTrial> trials = OneOfTwo();
  double before = LogLoss(Boost(trials, {.num_trees = 0}), trials);
  EXPECT_NEAR(before, std::log(2), 0.01);
  for (const int num_trees : {1, 2, 5, 20}) {
    const double loss = LogLoss(Boost(trials, {.num_trees = num_trees}), trials);
    EXPECT_LT(loss, before) << num_trees;
    before = loss;
  }
}

// By hand: bias log(3/3) = 0; in each leaf slope 2 · 0.5 and bend 2 · 0.25, so that a step of
// 0.15 · 1 / (0.5 + 3) is 43 thousandths.
TEST(Boost, TakesNewtonsStepByHand) {
  const std::vector<GraspTrial> trials = {Trial(0, 0, false), Trial(0, 0, false), Trial(1, 0, true),
                                          Trial(1, 0, true)};
  const GraspFunction function = Boost(trials, {.num_trees = 1, .rate = 0.15});
  EXPECT_EQ(function.bias, 0);
  EXPECT_EQ(function.trees.at(0).Of(trials[0].terms), -43);
  EXPECT_EQ(function.trees.at(0).Of(trials[2].terms), 43);
}

TEST(Boost, CountsTrialsByTheirWeight) {
  const std::vector<GraspTrial> trials = {Trial(0, 0, false, 9), Trial(0, 0, true),
                                          Trial(1, 0, false), Trial(1, 0, true, 9)};
  const GraspFunction function = Boost(trials);
  EXPECT_GT(ProbabilityAt(function, 1, 0), 0.7);
  EXPECT_LT(ProbabilityAt(function, 0, 0), 0.3);
}

TEST(Boost, AsksNothingWhereNothingDiffers) {
  const GraspFunction function = Boost({Trial(1, 1, true), Trial(1, 1, true)});
  EXPECT_TRUE(function.trees.empty());
  EXPECT_EQ(function.bias, 1099);  // log 3
  EXPECT_TRUE(Boost({}).trees.empty());
}

}  // namespace
}  // namespace fovea::evaluation
