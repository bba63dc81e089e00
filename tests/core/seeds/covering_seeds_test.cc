#include "core/seeds/covering_seeds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fovea {
namespace {

// One pixel a voxel along a line, 1 cm apart; pixels listed in `gaps` are left out.
VoxelGrid Line(int length, const std::vector<int>& gaps = {}) {
  cv::Mat points(1, length, CV_32FC3);
  for (int i = 0; i < length; ++i) {
    points.at<cv::Vec3f>(i) = {0.005F + 0.01F * static_cast<float>(i), 0.005F, 1.005F};
  }
  for (const int i : gaps) points.at<cv::Vec3f>(i) = cv::Vec3f::all(std::nanf(""));
  return BuildVoxelGrid(points, {cv::Mat(points.size(), CV_32FC3, cv::Scalar(0, 0, -1))});
}

std::vector<int> Columns(const std::vector<Seed>& seeds) {
  std::vector<int> columns;
  for (const Seed& seed : seeds) columns.push_back(seed.pixel.x);
  return columns;
}

TEST(CoverWithSeeds, StartsInTheMiddleAndReachesBothEnds) {
  const VoxelGrid grid = Line(21);
  const auto seeds = CoverWithSeeds(grid, std::vector<char>(21, 0), {}, {.spacing_m = 0.06});
  // 10 is the middle; both ends are 10 cm away; what is left is within 6 cm of one of the three.
  EXPECT_EQ(Columns(seeds), (std::vector<int>{10, 0, 20}));
  for (const Seed& seed : seeds) EXPECT_EQ(seed.source, Seed::Source::kUnexplainedRegion);
}

TEST(CoverWithSeeds, KeepsGivenSeedsAndAddsOnlyWhatIsMissing) {
  const VoxelGrid grid = Line(21);
  const Seed given{{10, 0}, grid.voxels[10].mean, Seed::Source::kColorSaliency};
  const auto near = CoverWithSeeds(grid, std::vector<char>(21, 0), {given}, {.spacing_m = 0.2});
  EXPECT_EQ(Columns(near), (std::vector<int>{10}));
  EXPECT_EQ(near[0].source, Seed::Source::kColorSaliency);
}

TEST(CoverWithSeeds, GivesEachLargeEnoughPartItsOwnSeed) {
  const VoxelGrid grid = Line(61, {20, 40});  // parts of 20, 19 and 20 voxels
  const auto seeds =
      CoverWithSeeds(grid, std::vector<char>(grid.voxels.size(), 0), {}, {.spacing_m = 0.5});
  ASSERT_EQ(seeds.size(), 2U);
  EXPECT_LT(seeds[0].pixel.x, 20);
  EXPECT_GT(seeds[1].pixel.x, 40);
}

TEST(CoverWithSeeds, LeavesTheBackgroundAlone) {
  const VoxelGrid grid = Line(21);
  EXPECT_TRUE(CoverWithSeeds(grid, std::vector<char>(21, 1), {}, {.spacing_m = 0.05}).empty());
}

TEST(CoverWithSeeds, LeavesPartsAloneThatAreTooLongForAnObject) {
  const VoxelGrid grid = Line(300, {145});  // parts of 144 and 153 cm
  const auto seeds =
      CoverWithSeeds(grid, std::vector<char>(grid.voxels.size(), 0), {}, {.spacing_m = 2});
  ASSERT_EQ(seeds.size(), 1U);
  EXPECT_LT(seeds[0].pixel.x, 145);
}

TEST(CoverWithSeeds, DoesNothingWithoutSpacing) {
  EXPECT_TRUE(CoverWithSeeds(Line(21), std::vector<char>(21, 0), {}, {.spacing_m = 0}).empty());
}

}  // namespace
}  // namespace fovea
