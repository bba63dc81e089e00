#include "core/segmentation/data_term.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <random>

namespace fovea {
namespace {

struct Scene {
  cv::Mat points = cv::Mat(12, 12, CV_32FC3);
  VoxelGrid grid;
  std::vector<Seed> seeds;
};

Scene RandomScene(unsigned seed, double voxel_m = 0.05) {
  Scene scene;
  std::mt19937 random(seed);
  const auto uniform = [&] { return static_cast<float>(random() % 1001) / 1000.0F; };
  for (auto it = scene.points.begin<cv::Vec3f>(); it != scene.points.end<cv::Vec3f>(); ++it) {
    *it = {0.1F * uniform(), 0.1F * uniform(), 1 + 0.1F * uniform()};
  }
  const cv::Mat normals(scene.points.size(), CV_32FC3, cv::Scalar(0, 0, -1));
  scene.grid = BuildVoxelGrid(scene.points, {normals}, {.size_m = voxel_m});
  for (int i = 0; i < 3; ++i) {
    scene.seeds.push_back({{}, {0.1F * uniform(), 0.1F * uniform(), 1.0F}});
  }
  return scene;
}

// Eq. 2 as printed: the mean over the voxel's points of −ln p(label | x).
double LiteralCost(const Scene& scene, int voxel, int label, const DataTermOptions& options) {
  double sum = 0;
  int count = 0;
  for (int row = 0; row < scene.points.rows; ++row) {
    for (int col = 0; col < scene.points.cols; ++col) {
      if (scene.grid.voxel_of_pixel.at<int>(row, col) != voxel) continue;
      const cv::Vec3f& p = scene.points.at<cv::Vec3f>(row, col);
      const auto probability = [&](int c) {  // Eq. 5
        const Eigen::Vector3d d =
            Eigen::Vector3d(p[0], p[1], p[2]) - scene.seeds[c].position.cast<double>();
        return std::exp(-options.gamma_per_m2 * d.squaredNorm());
      };
      double value = 0;
      if (label > 0) {
        value = probability(label - 1);
      } else {  // Eq. 6
        double least = 1;
        for (int c = 0; c < 3; ++c) least = std::min(least, 1 - probability(c));
        value = options.alpha * std::max(least, options.min_probability);
      }
      sum -= std::log(value);
      ++count;
    }
  }
  return sum / count;
}

TEST(DataTerm, HasTheDataTermAsPrinted) {
  const Scene scene = RandomScene(11);
  const DataTermOptions options;
  const std::vector<char> none(scene.grid.voxels.size(), 0);
  const auto choices = DataTerm(scene.grid, scene.points, none, {}, scene.seeds, options);
  ASSERT_EQ(choices.size(), 4U);
  for (int label = 0; label < 4; ++label) {
    ASSERT_EQ(choices[label].size(), scene.grid.voxels.size());
    for (const auto& choice : choices[label]) {
      EXPECT_NEAR(choice.cost, LiteralCost(scene, choice.node, label, options), 2e-3)
          << "voxel " << choice.node << " label " << label;
    }
  }
}

// The same where hypotheses reach a fraction of the scene: what is left out costs nothing else.
TEST(DataTerm, LeavesOutNothingWithinReach) {
  const Scene scene = RandomScene(15, 0.01);
  const DataTermOptions options{.gamma_per_m2 = 10'000, .min_probability = 1e-3};
  const std::vector<char> none(scene.grid.voxels.size(), 0);
  const auto choices = DataTerm(scene.grid, scene.points, none, {}, scene.seeds, options);
  const double max_cost = -std::log(options.min_probability);
  for (int label = 0; label < 4; ++label) {
    auto choice = choices[label].begin();
    for (int v = 0; v < static_cast<int>(scene.grid.voxels.size()); ++v) {
      const double cost = LiteralCost(scene, v, label, options);
      if (label > 0 && cost > 0.99 * max_cost) {
        if (choice != choices[label].end() && choice->node == v) ++choice;
        continue;  // about the limit or beyond it
      }
      ASSERT_NE(choice, choices[label].end());
      ASSERT_EQ(choice->node, v) << "label " << label;
      EXPECT_NEAR(choice->cost, cost, 2e-3) << "voxel " << v << " label " << label;
      ++choice;
    }
    if (label == 0) continue;
    EXPECT_LT(choices[label].size(), scene.grid.voxels.size());
  }
}

// Their only point is as far from the nearest seed as their mean: rounding must not lose that seed.
TEST(DataTerm, BackgroundOfSinglePointsKnowsTheirNearestSeed) {
  const Scene scene = RandomScene(12, 1e-4);
  ASSERT_EQ(scene.grid.voxels.size(), scene.points.total());
  const DataTermOptions options;
  const std::vector<char> none(scene.grid.voxels.size(), 0);
  const auto choices = DataTerm(scene.grid, scene.points, none, {}, scene.seeds, options);
  for (const auto& choice : choices[0]) {
    EXPECT_NEAR(choice.cost, LiteralCost(scene, choice.node, 0, options), 2e-3) << choice.node;
  }
}

// A voxel of two points, 2 cm apart: the right one is nearest to the seed that is farther from
// their mean. The third seed is farther from both.
TEST(DataTerm, BackgroundOfWideVoxelsKnowsTheNearestSeedOfEachPoint) {
  Scene scene;
  scene.points = cv::Mat(1, 2, CV_32FC3, cv::Scalar(0.02, 0.05, 1.01));
  scene.points.at<cv::Vec3f>(0, 1)[0] = 0.04F;
  const cv::Mat normals(scene.points.size(), CV_32FC3, cv::Scalar(0, 0, -1));
  scene.grid = BuildVoxelGrid(scene.points, {normals}, {.size_m = 0.05});
  ASSERT_EQ(scene.grid.voxels.size(), 1U);
  for (const float x_m : {0.01F, 0.065F, 0.2F}) scene.seeds.push_back({{}, {x_m, 0.05F, 1.01F}});
  const DataTermOptions options{.gamma_per_m2 = 1000};
  const auto choices = DataTerm(scene.grid, scene.points, {0}, {}, scene.seeds, options);
  EXPECT_NEAR(choices[0].front().cost, LiteralCost(scene, 0, 0, options), 1e-4);
  scene.seeds[1] = scene.seeds[2];  // and it matters
  EXPECT_LT(LiteralCost(scene, 0, 0, options), choices[0].front().cost - 0.1);
}

TEST(DataTerm, OffersNothingOnTheSupportAndBeyondReach) {
  Scene scene = RandomScene(12);
  scene.seeds[2].position.z() = 3.0F;  // two metres off: Eq. 5 is below min_probability
  std::vector<char> is_background(scene.grid.voxels.size(), 0);
  is_background[0] = 1;
  const auto choices = DataTerm(scene.grid, scene.points, is_background, {}, scene.seeds);
  EXPECT_EQ(choices[0].size(), scene.grid.voxels.size());
  EXPECT_EQ(choices[1].size(), scene.grid.voxels.size() - 1);
  EXPECT_EQ(choices[1].front().node, 1);
  EXPECT_TRUE(choices[3].empty());
}

// Section 3.2: "a probability value of one" for the background, Eq. 5 for the hypotheses.
TEST(DataTerm, BackgroundCostsNothingWhereThePointsAreOnTheSupport) {
  const Scene scene = RandomScene(14);
  const std::vector<char> none(scene.grid.voxels.size(), 0);
  cv::Mat on_support = cv::Mat::zeros(scene.points.size(), CV_8UC1);
  on_support.setTo(255, scene.grid.voxel_of_pixel == 2);
  const auto choices = DataTerm(scene.grid, scene.points, none, on_support, scene.seeds);
  const auto plain = DataTerm(scene.grid, scene.points, none, {}, scene.seeds);
  for (std::size_t v = 0; v < choices[0].size(); ++v) {
    EXPECT_EQ(choices[0][v].cost, v == 2 ? 0 : plain[0][v].cost) << v;
    EXPECT_EQ(choices[1][v].cost, plain[1][v].cost) << v;
  }
  // Of a voxel with one of n points on it, n - 1 count.
  on_support.setTo(0);
  cv::Mat last;
  cv::findNonZero(scene.grid.voxel_of_pixel == 2, last);
  const cv::Point pixel = last.at<cv::Point>(0);
  on_support.at<std::uint8_t>(pixel) = 255;
  const auto mixed = DataTerm(scene.grid, scene.points, none, on_support, scene.seeds);
  EXPECT_LT(mixed[0][2].cost, plain[0][2].cost);
  EXPECT_GT(mixed[0][2].cost, 0);
}

}  // namespace
}  // namespace fovea
