#include "tests/evaluation/object_fit/model_fit.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <vector>

namespace fovea::evaluation {
namespace {

constexpr unsigned kSampleSeed = 1;  // fixed: the bounds below are of these samples
constexpr int kFitIterations = 200;

enum class Says { kForObjects, kAgainstObjects };

// Segments that are joined to nothing: those with `term` above a half are objects, or the others,
// nine of ten times.
std::vector<TreeSample> SamplesWhere(ObjectTerm term, Says says, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform;
  std::vector<TreeSample> samples(400);
  for (TreeSample& sample : samples) {
    sample.tree.nodes.resize(1);
    sample.tree.num_segments = 1;
    sample.terms.resize(1);
    const double value = uniform(random);
    sample.terms[0][static_cast<std::size_t>(term)] = value;
    const bool is_as_said = uniform(random) < 0.9;
    const bool is_object = ((value > 0.5) == (says == Says::kForObjects)) == is_as_said;
    sample.states = {is_object ? NodeState::kIs : NodeState::kIsNot};
  }
  return samples;
}

TermFunction FunctionOf(ObjectTerm term, Says says, const FitPenalties& penalties) {
  const std::vector<TreeSample> samples = SamplesWhere(term, says, kSampleSeed);
  const ObjectModel model =
      FitModel(samples, ModelWithKnots(samples, ""), "", penalties, kFitIterations);
  return model.functions[static_cast<std::size_t>(term)];
}

double ChangeOf(const TermFunction& function) { return function.Of(0.9) - function.Of(0.1); }

// Before the first knot, and after each.
std::vector<double> SlopesOf(const TermFunction& function) {
  std::vector<double> slopes(function.slopes.size());
  std::partial_sum(function.slopes.begin(), function.slopes.end(), slopes.begin());
  return slopes;
}

TEST(FitModel, FindsWhatSpeaksForAnObjectAndAgainstIt) {
  EXPECT_GT(ChangeOf(FunctionOf(ObjectTerm::kHeight, Says::kForObjects, {0.1, 0.1})), 2);
  EXPECT_LT(ChangeOf(FunctionOf(ObjectTerm::kHeight, Says::kAgainstObjects, {0.1, 0.1})), -2);
  EXPECT_LT(ChangeOf(FunctionOf(ObjectTerm::kClosed, Says::kAgainstObjects, {0.1, 0.1})), -2);
  EXPECT_GT(ChangeOf(FunctionOf(ObjectTerm::kContrast, Says::kForObjects, {0.1, 0.1})), 2);
}

TEST(FitModel, WhatIsPlainlyAgainstAnObjectNeverSpeaksForOne) {
  for (const double slope :
       SlopesOf(FunctionOf(ObjectTerm::kClosed, Says::kForObjects, {0.1, 0.1}))) {
    EXPECT_LT(slope, 1e-6);
  }
}

TEST(FitModel, WhatIsPlainlyForAnObjectNeverSpeaksAgainstOne) {
  for (const double slope :
       SlopesOf(FunctionOf(ObjectTerm::kContrast, Says::kAgainstObjects, {0.1, 0.1}))) {
    EXPECT_GT(slope, -1e-6);
  }
}

TEST(FitModel, WherePenalizedAtKnotsAFunctionIsStraight) {
  const TermFunction function = FunctionOf(ObjectTerm::kHeight, Says::kForObjects, {0.1, 1e5});
  EXPECT_GT(function.slopes[0], 1);
  for (std::size_t k = 1; k < function.slopes.size(); ++k) EXPECT_NEAR(function.slopes[k], 0, 0.1);
}

TEST(FitModel, HearsNothingOfTheGroupThatIsLeftOut) {
  std::vector<TreeSample> samples =
      SamplesWhere(ObjectTerm::kHeight, Says::kForObjects, kSampleSeed);
  const auto fit = [&] {
    return FitModel(samples, ModelWithKnots(samples, "one"), "one", {}, kFitIterations);
  };
  const ObjectModel without = fit();
  std::vector<TreeSample> other =
      SamplesWhere(ObjectTerm::kArea, Says::kForObjects, kSampleSeed + 1);
  for (TreeSample& sample : other) sample.group = "one";
  samples.insert(samples.end(), other.begin(), other.end());
  const ObjectModel left_out = fit();
  for (std::size_t t = 0; t < kNumObjectTerms; ++t) {
    EXPECT_EQ(left_out.functions[t].slopes, without.functions[t].slopes) << "term " << t;
  }
}

}  // namespace
}  // namespace fovea::evaluation
