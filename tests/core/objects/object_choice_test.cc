#include "core/objects/object_choice.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace fovea {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// Segments 0, 1, 2; 3 joins 0 and 1, 4 joins 3 and 2.
MergeTree Tree() {
  MergeTree tree;
  tree.num_segments = 3;
  tree.nodes = {{.parent = 3},
                {.parent = 3},
                {.parent = 4},
                {.left = 0, .right = 1, .parent = 4},
                {.left = 3, .right = 2}};
  return tree;
}

// Of all sets of nodes none of which lies within another, by trying them.
std::vector<double> ByTrying(const MergeTree& tree, const std::vector<double>& log_weights) {
  const std::size_t count = tree.nodes.size();
  const auto is_apart = [&](unsigned set) {
    for (std::size_t n = 0; n < count; ++n) {
      if ((set >> n & 1U) == 0) continue;
      for (int a = tree.nodes[n].parent; a >= 0; a = tree.nodes[a].parent) {
        if ((set >> a & 1U) != 0) return false;
      }
    }
    return true;
  };
  std::vector<double> probabilities(count, 0);
  double total = 0;
  for (unsigned set = 0; set < 1U << count; ++set) {
    if (!is_apart(set)) continue;
    double odds = 1;
    for (std::size_t n = 0; n < count; ++n) {
      if ((set >> n & 1U) != 0) odds *= std::exp(log_weights[n]);
    }
    total += odds;
    for (std::size_t n = 0; n < count; ++n) {
      if ((set >> n & 1U) != 0) probabilities[n] += odds;
    }
  }
  for (double& probability : probabilities) probability /= total;
  return probabilities;
}

TEST(ObjectProbabilities, AreTheSharesOfAllWaysToSeeTheScene) {
  constexpr unsigned kSeed = 7;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> weight(-4, 4);
  for (int i = 0; i < 20; ++i) {
    std::vector<double> log_weights(5);
    for (double& w : log_weights) w = weight(random);
    const std::vector<double> found = ObjectProbabilities(Tree(), log_weights);
    const std::vector<double> expected = ByTrying(Tree(), log_weights);
    for (std::size_t n = 0; n < 5; ++n) EXPECT_NEAR(found[n], expected[n], 1e-12);
  }
}

TEST(ObjectProbabilities, StayFiniteForExtremeWeights) {
  const std::vector<double> found = ObjectProbabilities(Tree(), {1e4, -1e4, 0, 2e4, -1e4});
  EXPECT_DOUBLE_EQ(found[3], 1);
  EXPECT_DOUBLE_EQ(found[0], 0);
  EXPECT_DOUBLE_EQ(found[2], 0.5);
}

TEST(ChooseObjects, TakesAUnionOrItsPartsWhicheverIsLikelier) {
  EXPECT_THAT(ChooseObjects(Tree(), {0.1, 0.1, 0.6, 0.8, 0.1}, {0.3}), ElementsAre(2, 3));
  EXPECT_THAT(ChooseObjects(Tree(), {0.6, 0.7, 0.2, 0.3, 0.0}, {0.3}), ElementsAre(0, 1));
  EXPECT_THAT(ChooseObjects(Tree(), {0.1, 0.1, 0.2, 0.2, 0.9}, {0.3}), ElementsAre(4));
}

TEST(ChooseObjects, LeavesOutWhatIsNotLikelyEnough) {
  EXPECT_THAT(ChooseObjects(Tree(), {0.2, 0.2, 0.2, 0.2, 0.2}, {0.3}), IsEmpty());
  EXPECT_THAT(ChooseObjects({}, {}), IsEmpty());
}

TEST(LabelsOfChosen, AreThoseOfAllSegmentsWithin) {
  EXPECT_THAT(LabelsOfChosen(Tree(), {2, 3}, {0, 1, 2, 3, 0, 1}), ElementsAre(0, 2, 2, 1, 0, 2));
  EXPECT_THAT(LabelsOfChosen(Tree(), {1}, {0, 1, 2, 3}), ElementsAre(0, 0, 1, 0));
}

}  // namespace
}  // namespace fovea
