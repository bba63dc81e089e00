#include "core/segmentation/data_term.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/core/segmentation/seeded_points.h"

namespace fovea {
namespace {

TEST(DataTerm, HasTheDataTermAsPrinted) {
  const SeededPoints scene = RandomPoints(11);
  const DataTermOptions options;
  const auto choices = DataTerm(SitesOf(scene), scene.seeds, options);
  ASSERT_EQ(choices.size(), 4U);
  ASSERT_EQ(choices[0].size(), scene.grid.voxels.size());
  for (int label = 1; label < 4; ++label) {
    ASSERT_EQ(choices[label].size(), scene.grid.voxels.size());
    for (const auto& choice : choices[label]) {
      EXPECT_NEAR(choice.cost, LiteralCost(scene, choice.node, label, options), 2e-3)
          << "voxel " << choice.node << " label " << label;
    }
  }
}

// The same where hypotheses reach a fraction of the scene: what is left out costs nothing else.
TEST(DataTerm, LeavesOutNothingWithinReach) {
  const SeededPoints scene = RandomPoints(15, 0.01);
  const DataTermOptions options{.gamma_per_m2 = 10'000, .min_probability = 1e-3};
  const auto choices = DataTerm(SitesOf(scene), scene.seeds, options);
  const double max_cost = -std::log(options.min_probability);
  for (int label = 1; label < 4; ++label) {
    auto choice = choices[label].begin();
    for (int v = 0; v < static_cast<int>(scene.grid.voxels.size()); ++v) {
      const double cost = LiteralCost(scene, v, label, options);
      if (cost > 0.99 * max_cost) {
        if (choice != choices[label].end() && choice->node == v) ++choice;
        continue;  // about the limit or beyond it
      }
      ASSERT_NE(choice, choices[label].end());
      ASSERT_EQ(choice->node, v) << "label " << label;
      EXPECT_NEAR(choice->cost, cost, 2e-3) << "voxel " << v << " label " << label;
      ++choice;
    }
    EXPECT_LT(choices[label].size(), scene.grid.voxels.size());
  }
}

// Their only point is as far from the nearest seed as their mean.
TEST(DataTerm, BackgroundOfSinglePointsCostsWhatIsPrinted) {
  const SeededPoints scene = RandomPoints(12, 1e-4);
  ASSERT_EQ(scene.grid.voxels.size(), scene.points.total());
  const DataTermOptions options;
  const auto choices = DataTerm(SitesOf(scene), scene.seeds, options);
  for (const auto& choice : choices[0]) {
    EXPECT_NEAR(choice.cost, LiteralCost(scene, choice.node, 0, options), 2e-3) << choice.node;
  }
}

TEST(DataTerm, BackgroundCostsAsMuchAsAtTheMeanDistanceOfTheNearestSeed) {
  const SeededPoints scene = RandomPoints(11);
  const DataTermOptions options;
  const auto choices = DataTerm(SitesOf(scene), scene.seeds, options);
  for (std::size_t v = 0; v < scene.grid.voxels.size(); ++v) {
    const float least = std::min({choices[1][v].cost, choices[2][v].cost, choices[3][v].cost});
    const auto squared_distance = static_cast<float>(least / options.gamma_per_m2);  // Eq. 5
    EXPECT_NEAR(choices[0][v].cost, BackgroundCost(squared_distance, options), 1e-3) << v;
    EXPECT_NEAR(choices[0][v].cost, LiteralCost(scene, static_cast<int>(v), 0, options), 0.5) << v;
  }
}

TEST(DataTerm, BackgroundCostsLeastFarFromAllSeeds) {
  const DataTermOptions options;
  EXPECT_NEAR(BackgroundCost(1e3F, options), -std::log(options.alpha), 1e-4);
  EXPECT_NEAR(BackgroundCost(0, options), -std::log(options.alpha * options.min_probability), 1e-4);
}

TEST(DataTerm, OffersNothingBeyondReach) {
  SeededPoints scene = RandomPoints(12);
  scene.seeds[2].position.z() = 3.0F;  // two metres off: Eq. 5 is below min_probability
  const auto choices = DataTerm(SitesOf(scene), scene.seeds);
  EXPECT_EQ(choices[0].size(), scene.grid.voxels.size());
  EXPECT_EQ(choices[1].size(), scene.grid.voxels.size());
  EXPECT_TRUE(choices[3].empty());
}

TEST(DataTerm, CostsASiteOfSeveralVoxelsSoOften) {
  const SeededPoints scene = RandomPoints(11);
  Sites sites = SitesOf(scene);
  const auto single = DataTerm(sites, scene.seeds);
  sites.weights[1] = 7;
  const auto choices = DataTerm(sites, scene.seeds);
  ASSERT_EQ(choices.size(), 4U);
  for (int label = 0; label < 4; ++label) {
    ASSERT_EQ(choices[label].size(), single[label].size());
    EXPECT_EQ(choices[label][0].cost, single[label][0].cost);
    EXPECT_EQ(choices[label][1].cost, 7 * single[label][1].cost);
  }
}

}  // namespace
}  // namespace fovea
