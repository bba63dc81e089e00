#include "core/segmentation/hollow_fill.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <opencv2/core.hpp>

#include "core/segmentation/hollow_wall.h"
#include "core/segmentation/labels.h"

namespace fovea {
namespace {

const Eigen::Vector3f kUp = -Eigen::Vector3f::UnitY();
constexpr HollowFillOptions kOptions{.max_radius_m = 0.2};
constexpr CameraIntrinsics kCamera{100, 100, 31.5, 23.5};

// The same depth everywhere, NaN = nothing measured.
cv::Mat PointsAt(float z) { return {48, 64, CV_32FC3, cv::Scalar(0, 0, z)}; }
const cv::Mat kUnmeasured = PointsAt(std::numeric_limits<float>::quiet_NaN());

// A cup of 5 cm radius and 8 cm height on a table, most of its wall seen from inside: labels 1 and
// 2 left and right of the middle. Its floor and the table around it are background.
struct Cup {
  VoxelGrid grid;
  std::vector<int> labels;
  std::vector<char> on_wall;

  void Add(float x, float height, float z, const Eigen::Vector3f& normal, int label) {
    Voxel voxel;
    voxel.mean = {x, -height, z};
    voxel.normal = normal;
    voxel.num_points = 1;
    grid.voxels.push_back(voxel);
    labels.push_back(label);
  }
  // `facing`: 1 = normals inwards, -1 = outwards.
  explicit Cup(float facing = 1, float gap_m = 0) {
    for (int degree = -25; degree < 210; degree += 10) {
      const float angle = static_cast<float>(degree) * std::numbers::pi_v<float> / 180;
      const Eigen::Vector3f out(std::cos(angle), 0, std::sin(angle));
      for (float height = 0.015F; height < 0.08F; height += 0.01F) {
        const float shift = degree < 90 ? gap_m : 0;
        Add(0.05F * out.x() + shift, height, 1 + 0.05F * out.z(), -facing * out,
            degree < 90 ? 1 : 2);
      }
    }
    for (float x = -0.1F; x < 0.1F; x += 0.01F) {
      for (float z = 0.9F; z < 1.1F; z += 0.01F) Add(x, 0.005F, z, kUp, 0);
    }
    for (int a = 0; a < static_cast<int>(labels.size()); ++a) {
      for (int b = a + 1; b < static_cast<int>(labels.size()); ++b) {
        const float distance = (grid.voxels[a].mean - grid.voxels[b].mean).norm();
        if (distance < 0.0145F) grid.edges.push_back({a, b});
      }
    }
    on_wall.assign(labels.size(), 0);
  }

  std::vector<int> Fill(const HollowFillOptions& options = kOptions,
                        const cv::Mat& points = kUnmeasured) const {
    return FillHollows(grid, labels, points, kCamera, on_wall, kUp, options);
  }
  // The label of the table's voxel nearest to a place.
  int LabelAt(const std::vector<int>& result, float x, float z) const {
    std::size_t nearest = 0;
    for (std::size_t v = 0; v < result.size(); ++v) {
      const Eigen::Vector3f place(x, -0.005F, z);
      if ((grid.voxels[v].mean - place).norm() < (grid.voxels[nearest].mean - place).norm())
        nearest = v;
    }
    return result[nearest];
  }
};

TEST(FindHollowWalls, MeasuresTheCircleOfAWallSeenFromInside) {
  const Cup cup;
  const auto walls = FindHollowWalls(cup.grid, cup.labels, kUp, 0.2);
  ASSERT_EQ(walls.size(), 3U);
  EXPECT_FALSE(walls[0]);
  ASSERT_TRUE(walls[1] && walls[2]);
  EXPECT_NEAR(walls[1]->radius_m, 0.05, 1e-4);
  EXPECT_NEAR(walls[1]->rim_m, 0.075, 1e-4);
  EXPECT_NEAR(walls[1]->foot_m, 0.015, 1e-4);
  EXPECT_TRUE(AreOneWall(*walls[1], *walls[2]));
}

TEST(FindHollowWalls, FindsNoneFromOutsideOrBeyondTheRadius) {
  const Cup outside(-1);
  EXPECT_FALSE(FindHollowWalls(outside.grid, outside.labels, kUp, 0.2)[1]);
  const Cup cup;
  EXPECT_FALSE(FindHollowWalls(cup.grid, cup.labels, kUp, 0.04)[1]);
}

TEST(FillHollows, JoinsThePiecesOfOneWallAndFillsInItsFloor) {
  const Cup cup;
  const std::vector<int> filled = cup.Fill();
  EXPECT_EQ(filled[0], 1);
  EXPECT_EQ(CountLabels(filled), 1U);
  EXPECT_EQ(cup.LabelAt(filled, 0, 1.02F), 1);
  EXPECT_EQ(cup.LabelAt(filled, 0.08F, 1), 0);  // the table beside it
}

TEST(FillHollows, LeavesWhatHasNoRimForMostOfItsCircle) {
  const Cup cup;
  EXPECT_EQ(cup.LabelAt(cup.Fill(kOptions, PointsAt(0.9F)), 0, 1.02F), 1);  // a rim in front of it
  cv::Mat beyond = PointsAt(3);  // one sees through where a rim would be …
  EXPECT_EQ(cup.LabelAt(cup.Fill(kOptions, beyond), 0, 1.02F), 0);
  beyond.colRange(0, 34).setTo(cv::Scalar(0, 0, 0.9));  // … but for its left half
  EXPECT_EQ(cup.LabelAt(cup.Fill(kOptions, beyond), 0, 1.02F), 1);
}

TEST(FillHollows, KeepsApartWallsThatStandBesideEachOther) {
  const Cup cups(1, 0.04F);
  EXPECT_EQ(CountLabels(cups.Fill()), 2U);
}

TEST(FillHollows, LeavesTheOutsideOfRoundThings) {
  const Cup cylinder(-1);
  EXPECT_EQ(cylinder.Fill(), cylinder.labels);
}

TEST(FillHollows, LeavesWallsOfTheRoom) {
  Cup cup;
  cup.on_wall.assign(cup.labels.size(), 1);
  EXPECT_EQ(cup.LabelAt(cup.Fill(), 0, 1.02F), 0);
}

TEST(FillHollows, FillsOnlyWhatIsConnectedWithTheInside) {
  Cup cup;
  std::erase_if(cup.grid.edges, [&](const VoxelEdge& edge) {
    return (cup.labels[edge.a] == 0) != (cup.labels[edge.b] == 0);
  });
  EXPECT_EQ(cup.LabelAt(cup.Fill(), 0, 1.02F), 0);
}

TEST(FillHollows, IsOffAtZero) {
  const Cup cup;
  EXPECT_EQ(cup.Fill({.max_radius_m = 0}), cup.labels);
}

}  // namespace
}  // namespace fovea
