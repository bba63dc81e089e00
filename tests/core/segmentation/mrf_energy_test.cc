#include "core/segmentation/mrf_energy.h"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/core/segmentation/seeded_points.h"

namespace fovea {
namespace {

Voxel At(float x, const Eigen::Vector3f& normal) {
  return {.mean = {x, 0, 1}, .normal = normal.normalized(), .num_points = 1};
}

TEST(PairwiseWeight, FallsWithGroovesAndSteps) {
  MrfOptions options{.lambda = 7, .concave_angle_deg = 12, .step_weight = 0};
  const Eigen::Vector3f left(-1, 0, -1);
  const Eigen::Vector3f right(1, 0, -1);
  const Eigen::Vector3f front(0, 0, -1);
  EXPECT_NEAR(PairwiseWeight(At(0, left), At(0.01F, right), options), 7, 1e-5);
  EXPECT_NEAR(PairwiseWeight(At(0, right), At(0.01F, left), options), 7 * std::exp(-90 / 12.0),
              1e-5);
  Voxel behind = At(0.01F, front);
  behind.mean.z() += 0.01F;  // a step of 45°
  EXPECT_NEAR(PairwiseWeight(At(0, front), behind, options), 7, 1e-5);
  options.step_weight = 0.5;
  EXPECT_NEAR(PairwiseWeight(At(0, front), behind, options), 7 * std::exp(-22.5 / 12), 1e-4);
  EXPECT_NEAR(PairwiseWeight(At(0, left), At(0.01F, right), options), 7, 1e-5);
}

MeanColor Color(double hue) { return {{0, hue, 0}, 1}; }

TEST(ColorShare, FallsWithTheDistanceOfTheColors) {
  const MrfOptions options{.color_floor = 0.3};
  EXPECT_EQ(ColorShare(Color(0), Color(12), options), 1);
  EXPECT_NEAR(ColorShare(Color(0), Color(20), options), 0.3 + 0.7 * std::exp(-1), 1e-6);
  EXPECT_EQ(ColorShare(Color(3), Color(18), options), ColorShare(Color(18), Color(3), options));
  EXPECT_NEAR(ColorShare(Color(0), Color(1000), options), 0.3, 1e-6);
}

// Where both may be objects: a support's colour says nothing of what stands on it.
TEST(BuildEnergy, WeighsColorsBetweenWhatMayBeObjects) {
  const SeededPoints scene = RandomPoints(13);
  std::vector<char> is_background(scene.grid.voxels.size(), 0);
  is_background[0] = 1;
  std::vector<MeanColor> colors;
  for (std::size_t v = 0; v < scene.grid.voxels.size(); ++v) {
    colors.push_back(Color(v % 2 == 0 ? 0 : 1000));
  }
  const auto edges = [&](double floor) {  // of single voxels, all but the first
    return BuildEnergy(scene.grid, colors, is_background, scene.seeds,
                       {.color_floor = floor, .cluster_voxels = 1})
        .energy.edges;
  };
  const auto plain = edges(1), colored = edges(0.3);
  ASSERT_EQ(plain.size(), colored.size());
  std::size_t num_lighter = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const bool differ = plain[i].a % 2 != plain[i].b % 2;
    EXPECT_NEAR(colored[i].weight, (differ ? 0.3F : 1.0F) * plain[i].weight, 1e-5);
    num_lighter += differ ? 1 : 0;
  }
  EXPECT_GT(num_lighter, 0U);
}

// What is labelled together is one site: around the mean of its voxels, and pulled to the
// background by all of them.
TEST(BuildEnergy, IsOfClusters) {
  VoxelGrid grid;
  for (const float x : {0.0F, 0.01F, 0.02F}) grid.voxels.push_back(At(x, {0, 0, -1}));
  grid.edges = {{0, 1}, {1, 2}};
  const std::vector<MeanColor> colors(3, Color(0));
  const std::vector<Seed> seeds{{{}, {0.015F, 0, 1.02F}}};
  const MrfOptions options;
  const auto [energy, clusters] = BuildEnergy(grid, colors, {1, 0, 0}, seeds, options);
  EXPECT_THAT(clusters.of_node, ::testing::ElementsAre(-1, 0, 0));
  EXPECT_TRUE(energy.edges.empty());
  ASSERT_EQ(energy.choices.size(), 2U);
  ASSERT_EQ(energy.choices[1].size(), 1U);
  const float squared = 0.005F * 0.005F + 0.02F * 0.02F;  // of either voxel to the seed
  EXPECT_NEAR(energy.choices[1][0].cost, 2 * options.data.gamma_per_m2 * squared, 1e-5);
  EXPECT_NEAR(energy.choices[0][0].cost, 2 * BackgroundCost(squared, options.data) - options.lambda,
              1e-4);
}

TEST(PairwiseWeight, DoesNotDependOnTheOrder) {
  const Voxel a = At(0, {-0.2F, 0.1F, -1});
  const Voxel b = At(0.01F, {0.3F, 0.2F, -1});
  EXPECT_EQ(PairwiseWeight(a, b, {}), PairwiseWeight(b, a, {}));
}

}  // namespace
}  // namespace fovea
