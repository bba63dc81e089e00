#include "core/scene/flat_things.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <opencv2/core.hpp>
#include <set>

#include "core/types/lab.h"

namespace fovea {
namespace {

constexpr int kSide = 100;           // voxels along each side of the table
constexpr float kSpacing_m = 0.01F;  // between them
constexpr SupportOptions kTolerance{.tolerance_m = 0.004, .tolerance_per_m = 0.006};
const cv::Vec3b kTableColor(120, 90, 60), kSteel(150, 160, 180), kBlue(30, 60, 160);

// A table 1 m below the camera that looks down on it, a voxel a pixel.
struct Table {
  Table()
      : color_rgb(kSide, kSide, CV_8UC3, kTableColor),
        is_background(std::size_t{kSide} * kSide, 1) {
    grid.voxel_of_pixel.create(kSide, kSide, CV_32SC1);
    std::iota(grid.voxel_of_pixel.begin<int>(), grid.voxel_of_pixel.end<int>(), 0);
    for (int row = 0; row < kSide; ++row) {
      for (int col = 0; col < kSide; ++col) {
        grid.voxels.push_back({.mean = {col * kSpacing_m - 0.5F, row * kSpacing_m - 0.5F, 1},
                               .normal = -Eigen::Vector3f::UnitZ(),
                               .num_points = 1});
        const int v = row * kSide + col;
        if (col > 0) grid.edges.push_back({v - 1, v});
        if (row > 0) grid.edges.push_back({v - kSide, v});
      }
    }
  }

  void Put(const cv::Rect& at, const cv::Vec3b& color, float height_m) {
    color_rgb(at).setTo(color);
    ForEach(at, [&](int v) { grid.voxels[v].mean.z() = 1 - height_m; });
  }

  static void ForEach(const cv::Rect& at, const std::function<void(int)>& visit) {
    for (int row = at.y; row < at.br().y; ++row) {
      for (int col = at.x; col < at.br().x; ++col) visit(row * kSide + col);
    }
  }

  std::vector<char> Find(const FlatThingOptions& options = {}) const {
    Support support;
    support.surface.normal = -Eigen::Vector3f::UnitZ();
    support.surface.offset_m = 1;
    return FindFlatThings(grid, ColorsOfVoxels(grid, LabOf(color_rgb)), is_background, {support},
                          kTolerance, options);
  }

  int CountIn(const cv::Rect& at, const std::vector<char>& found) const {
    int count = 0;
    ForEach(at, [&](int v) { count += found[v]; });
    return count;
  }

  VoxelGrid grid;
  cv::Mat color_rgb;
  std::vector<char> is_background;
};

int Count(const std::vector<char>& found) { return std::accumulate(found.begin(), found.end(), 0); }

const cv::Rect kRuler(20, 30, 25, 4);

TEST(FindFlatThings, FindsWhatIsLowAndOfAnotherColor) {
  Table table;
  table.Put(kRuler, kBlue, 0.003F);
  const std::vector<char> found = table.Find();
  EXPECT_EQ(table.CountIn(kRuler, found), kRuler.area());
  EXPECT_EQ(Count(found), kRuler.area());
}

TEST(FindFlatThings, NotWhatHasTheColorOfTheSupport) {
  Table table;
  table.Put(kRuler, kTableColor, 0.003F);
  EXPECT_EQ(Count(table.Find()), 0);
}

TEST(FindFlatThings, NotPrints) {
  Table table;
  table.Put(kRuler, kBlue, 0);
  EXPECT_EQ(Count(table.Find()), 0);
}

TEST(FindFlatThings, NotTheFieldsOfAChequeredCloth) {
  Table table;
  for (int row = 0; row < kSide; row += 20) {
    for (int col = (row / 20) % 2 * 20; col < kSide; col += 40) {
      table.Put({col, row, 20, 20}, kBlue, 0.003F);
    }
  }
  EXPECT_EQ(Count(table.Find()), 0);
}

TEST(FindFlatThings, NeitherSpecksNorSheets) {
  Table table;
  table.Put({10, 10, 3, 3}, kBlue, 0.003F);
  table.Put({2, 60, 60, 4}, kBlue, 0.003F);
  EXPECT_EQ(Count(table.Find()), 0);
}

TEST(FindFlatThings, NotTheEdgesOfObjectsButTheirThinEnds) {
  Table table;
  const cv::Rect handle(40, 20, 6, 20), edge(46, 20, 2, 20), blade(40, 40, 6, 25);
  table.Put(handle, kSteel, 0.02F);
  Table::ForEach(handle, [&](int v) { table.is_background[v] = 0; });
  table.Put(edge, kBlue, 0.003F);
  table.Put(blade, kBlue, 0.003F);
  const std::vector<char> found = table.Find();
  EXPECT_EQ(table.CountIn(handle, found), 0) << "of the background only";
  EXPECT_GT(table.CountIn(blade, found), 0.9 * blade.area());
  EXPECT_LT(table.CountIn(edge, found), 0.4 * edge.area());
}

TEST(FindFlatThings, NothingWhereItIsSwitchedOff) {
  Table table;
  table.Put(kRuler, kBlue, 0.003F);
  EXPECT_EQ(Count(table.Find({.min_contrast = 0})), 0);
}

}  // namespace
}  // namespace fovea
