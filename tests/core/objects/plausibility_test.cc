#include "core/objects/plausibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace fovea {
namespace {

const Eigen::Vector3f kUp = -Eigen::Vector3f::UnitY();

// Voxels of 1 cm; heights are above the floor at y = 0, in cells.
struct Scene {
  VoxelGrid grid;
  std::vector<int> labels;

  // Fills the cells from `low` up to, without, `high`: (x, height, z).
  void Add(int label, const Eigen::Vector3i& low, const Eigen::Vector3i& high) {
    for (int x = low.x(); x < high.x(); ++x) {
      for (int height = low.y(); height < high.y(); ++height) {
        for (int z = low.z(); z < high.z(); ++z) {
          const Eigen::Vector3i cell(x, -height - 1, z);
          grid.voxels.push_back(
              {.cell = cell, .mean = 0.01F * (cell.cast<float>().array() + 0.5F).matrix()});
          labels.push_back(label);
        }
      }
    }
  }

  bool Has(int label, const PlausibleSegments& plausible) const {
    for (std::size_t v = 0; v < labels.size(); ++v) {
      if (labels[v] == label && plausible.labels[v] != label) return false;
    }
    return std::count(plausible.labels.begin(), plausible.labels.end(), label) > 0;
  }
};

const Support kFloor{{kUp, 0, 1}, Footprint()};

// 70 cm above the floor, over x 0 … 1, z 1 … 1.6.
Support Table() {
  const SupportSurface surface{kUp, -0.7F, 1};
  std::vector<Eigen::Vector3f> points;
  for (int x = 0; x <= 50; ++x) {
    for (int z = 0; z <= 30; ++z) {
      points.emplace_back(0.02F * static_cast<float>(x), -0.7F, 1 + 0.02F * static_cast<float>(z));
    }
  }
  return {surface, Footprint(points, {}, surface, 0, 0)};
}

constexpr SupportOptions kSupport{.tolerance_m = 0.002};
constexpr PlausibilityOptions kOptions{.max_size_m = 0.5, .max_hang_m = 0.1, .max_rest_m = 0.05};

TEST(RemoveImplausible, KeepsWhatRests) {
  Scene scene;
  scene.Add(1, {0, 0, 100}, {5, 10, 105});
  scene.Add(2, {40, 70, 120}, {45, 80, 125});  // on the table
  const auto plausible =
      RemoveImplausible(scene.grid, scene.labels, {}, {}, {kFloor, Table()}, kSupport, kOptions);
  EXPECT_EQ(plausible.labels, scene.labels);
  EXPECT_EQ(plausible.num_removed, 0U);
}

TEST(RemoveImplausible, RemovesWhatIsTooLargeAlongAnyAxis) {
  Scene scene;
  scene.Add(1, {0, 0, 100}, {60, 5, 105});   // 59 cm between the outer means
  scene.Add(2, {0, 0, 120}, {5, 60, 125});   // upright
  scene.Add(3, {0, 0, 140}, {45, 45, 145});  // 44 cm
  const auto plausible =
      RemoveImplausible(scene.grid, scene.labels, {}, {}, {kFloor}, kSupport, kOptions);
  EXPECT_FALSE(scene.Has(1, plausible));
  EXPECT_FALSE(scene.Has(2, plausible));
  EXPECT_TRUE(scene.Has(3, plausible));
  EXPECT_EQ(plausible.num_removed, 2U);
}

TEST(RemoveImplausible, RemovesLumpsOfNoise) {
  Scene scene;
  scene.Add(1, {0, 1, 100}, {3, 2, 103});    // 90 pixels, 15 mm high
  scene.Add(2, {20, 1, 100}, {26, 2, 106});  // 360 pixels
  scene.Add(3, {40, 1, 100}, {42, 4, 102});  // 120 pixels, 35 mm high
  for (Voxel& voxel : scene.grid.voxels) voxel.num_points = 10;
  PlausibilityOptions options = kOptions;
  options.min_low_pixels = 200;
  const SupportOptions support{.tolerance_m = 0.01};
  const cv::Mat points(480, 640, CV_32FC3, cv::Scalar::all(0));
  const auto plausible =
      RemoveImplausible(scene.grid, scene.labels, points, {}, {kFloor}, support, options);
  EXPECT_FALSE(scene.Has(1, plausible));
  EXPECT_TRUE(scene.Has(2, plausible));
  EXPECT_TRUE(scene.Has(3, plausible));
  // Noise has as many pixels in a smaller image, and more in one that was made larger.
  const auto num_lumps = [&](const cv::Size& size) {
    const cv::Mat image(size, CV_32FC3, cv::Scalar::all(0));
    return RemoveImplausible(scene.grid, scene.labels, image, {}, {kFloor}, support, options)
        .num_removed;
  };
  EXPECT_EQ(num_lumps({320, 240}), 1U);
  EXPECT_EQ(num_lumps({1280, 960}), 2U);
}

TEST(RemoveImplausible, RemovesTheBackOfAChairFromItsSeat) {
  Scene scene;
  scene.Add(1, {5, 70, 150}, {45, 105, 155});   // 39 cm wide, 34 cm high
  scene.Add(2, {55, 70, 110}, {95, 75, 140});   // as wide, but flat
  scene.Add(3, {55, 70, 150}, {80, 115, 155});  // as large, but narrow
  const Support seat = Table();
  PlausibilityOptions options = kOptions;
  options.max_support_share = 0.12 / seat.footprint.AreaM2();
  const auto plausible =
      RemoveImplausible(scene.grid, scene.labels, {}, {}, {kFloor, seat}, kSupport, options);
  EXPECT_FALSE(scene.Has(1, plausible));
  EXPECT_TRUE(scene.Has(2, plausible));
  EXPECT_TRUE(scene.Has(3, plausible));
  // Something close to the camera may be larger than what is seen of the surface below.
  EXPECT_EQ(RemoveImplausible(scene.grid, scene.labels, {}, {}, {seat, kFloor}, kSupport, options)
                .num_removed,
            0U);
}

TEST(RemoveImplausible, RemovesTheBackOfAChairWhoseSeatIsAsHighAsATable) {
  const SupportSurface surface{kUp, -0.7F, 1};
  std::vector<Eigen::Vector3f> points;
  for (int x = 0; x <= 120; ++x) {
    for (int z = 0; z <= 30; ++z) {
      if (x > 50 && x < 100) continue;  // a table up to 1 m, a seat from 2 m to 2.4 m
      points.emplace_back(0.02F * static_cast<float>(x), -0.7F, 1 + 0.02F * static_cast<float>(z));
    }
  }
  const Support both{surface, Footprint(points, {}, surface, 0, 0)};
  ASSERT_EQ(both.footprint.PartAreasM2().size(), 2U);
  PlausibilityOptions options = kOptions;
  options.max_support_share = 0.3;
  Scene scene;
  scene.Add(1, {200, 70, 155}, {239, 105, 158});  // 38 cm wide, 34 cm high, on the seat
  scene.Add(2, {20, 70, 155}, {59, 105, 158});    // the same on the table
  const auto plausible =
      RemoveImplausible(scene.grid, scene.labels, {}, {}, {kFloor, both}, kSupport, options);
  EXPECT_FALSE(scene.Has(1, plausible));
  EXPECT_TRUE(scene.Has(2, plausible));
  // Also where most of the level points are at this height.
  EXPECT_FALSE(scene.Has(
      1, RemoveImplausible(scene.grid, scene.labels, {}, {}, {both, kFloor}, kSupport, options)));
}

TEST(RemoveImplausible, RemovesALegThatHangsFromItsTable) {
  Scene scene;
  scene.Add(1, {5, 25, 105}, {8, 68, 108});      // a leg, 2 cm below the top
  scene.Add(2, {40, 0, 120}, {50, 30, 130});     // a box under the table
  scene.Add(3, {120, 25, 105}, {123, 29, 108});  // beside the table, in the air
  PlausibilityOptions options = kOptions;
  options.max_rest_m = 100;
  const auto plausible =
      RemoveImplausible(scene.grid, scene.labels, {}, {}, {kFloor, Table()}, kSupport, options);
  EXPECT_FALSE(scene.Has(1, plausible));
  EXPECT_TRUE(scene.Has(2, plausible));
  EXPECT_TRUE(scene.Has(3, plausible));
  EXPECT_EQ(plausible.num_removed, 1U);
  options.max_hang_m = 0;
  EXPECT_EQ(
      RemoveImplausible(scene.grid, scene.labels, {}, {}, {kFloor, Table()}, kSupport, options)
          .num_removed,
      0U);
}

TEST(RemoveImplausible, RemovesTheLowerEndOfALegThatIsSeenInTwoPieces) {
  Scene scene;
  scene.Add(1, {5, 35, 105}, {8, 68, 108});   // the upper end, 2 cm below the top
  scene.Add(2, {6, 0, 104}, {10, 30, 107});   // the lower end
  scene.Add(3, {11, 0, 100}, {30, 30, 115});  // a box beside it
  const auto plausible =
      RemoveImplausible(scene.grid, scene.labels, {}, {}, {kFloor, Table()}, kSupport, kOptions);
  EXPECT_FALSE(scene.Has(1, plausible));
  EXPECT_FALSE(scene.Has(2, plausible));
  EXPECT_TRUE(scene.Has(3, plausible));
}

TEST(RemoveImplausible, KeepsWhatReachesOverTheEdgeOfTheTableForLess) {
  Scene scene;
  scene.Add(1, {40, 68, 120}, {45, 80, 125});  // 2 of 12 cm below its surface
  EXPECT_EQ(
      RemoveImplausible(scene.grid, scene.labels, {}, {}, {kFloor, Table()}, kSupport, kOptions)
          .num_removed,
      0U);
}

TEST(RemoveImplausible, RemovesWhatFloats) {
  Scene scene;
  scene.Add(1, {0, 10, 100}, {5, 15, 105});  // lowest mean 10.5 cm above the floor
  scene.Add(2, {20, 4, 100}, {25, 9, 105});  // 4.5 cm
  const auto plausible =
      RemoveImplausible(scene.grid, scene.labels, {}, {}, {kFloor}, kSupport, kOptions);
  EXPECT_FALSE(scene.Has(1, plausible));
  EXPECT_TRUE(scene.Has(2, plausible));
  EXPECT_EQ(plausible.num_removed, 1U);
}

TEST(RemoveImplausible, RemovesWhatLiesBelowEverySupport) {
  Scene scene;
  scene.Add(1, {0, -10, 100}, {5, -5, 105});
  EXPECT_EQ(RemoveImplausible(scene.grid, scene.labels, {}, {}, {kFloor}, kSupport, {}).num_removed,
            1U);
}

TEST(RemoveImplausible, KeepsWhatTouchesSomethingThatRestsAlsoThroughOthers) {
  Scene scene;
  scene.Add(3, {0, 20, 100}, {5, 30, 105});  // on 2
  scene.Add(2, {0, 10, 100}, {5, 20, 105});  // on 1
  scene.Add(1, {0, 0, 100}, {5, 10, 105});
  scene.Add(4, {0, 31, 100}, {5, 35, 105});  // one cell of air is bridged
  scene.Add(5, {0, 37, 100}, {5, 40, 105});  // two are not
  const auto plausible =
      RemoveImplausible(scene.grid, scene.labels, {}, {}, {kFloor}, kSupport, kOptions);
  for (const int label : {1, 2, 3, 4}) EXPECT_TRUE(scene.Has(label, plausible)) << label;
  EXPECT_FALSE(scene.Has(5, plausible));
  EXPECT_EQ(plausible.num_removed, 1U);
}

TEST(RemoveImplausible, NothingRestsOnWhatIsRemoved) {
  Scene scene;
  scene.Add(1, {0, 0, 100}, {5, 80, 105});    // a wall
  scene.Add(2, {5, 40, 100}, {10, 50, 105});  // a picture on it
  const auto plausible =
      RemoveImplausible(scene.grid, scene.labels, {}, {}, {kFloor}, kSupport, kOptions);
  EXPECT_EQ(plausible.labels, std::vector<int>(scene.labels.size(), 0));
  EXPECT_EQ(plausible.num_removed, 2U);
}

TEST(RemoveImplausible, RemovesNothingWithoutSupports) {
  Scene scene;
  scene.Add(1, {0, 10, 100}, {80, 15, 105});
  const auto plausible =
      RemoveImplausible(scene.grid, scene.labels, {}, {}, {}, kSupport, kOptions);
  EXPECT_EQ(plausible.labels, scene.labels);
  EXPECT_EQ(plausible.num_removed, 0U);
}

}  // namespace
}  // namespace fovea
