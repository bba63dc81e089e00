#include "core/segmentation/hollow_fill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <opencv2/core.hpp>

#include "core/segmentation/labels.h"
#include "tests/core/segmentation/cup.h"

namespace fovea {
namespace {

constexpr CameraIntrinsics kCamera{100, 100, 31.5, 23.5};

// The same depth everywhere, NaN = nothing measured.
cv::Mat PointsAt(float z) { return {48, 64, CV_32FC3, cv::Scalar(0, 0, z)}; }
const cv::Mat kUnmeasured = PointsAt(std::numeric_limits<float>::quiet_NaN());

struct HollowCup : Cup {
  using Cup::Cup;
  std::vector<int> objects = labels;  // joined from the pieces

  std::vector<int> Fill(const cv::Mat& points = kUnmeasured, double max_radius_m = 0.2) const {
    const RoundWalls walls = FindRoundWalls(grid, labels, kUp, max_radius_m);
    return FillHollows(grid, objects, labels, walls, points, kCamera, on_wall, kUp);
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

TEST(FillHollows, GivesTheFloorToTheObjectOfTheWall) {
  HollowCup cup;
  cup.objects = std::vector<int>(cup.labels.size());
  std::transform(cup.labels.begin(), cup.labels.end(), cup.objects.begin(),
                 [](int label) { return std::min(label, 1); });  // both pieces
  const std::vector<int> filled = cup.Fill();
  EXPECT_EQ(CountLabels(filled), 1U);
  EXPECT_EQ(cup.LabelAt(filled, 0, 1.02F), 1);
  EXPECT_EQ(cup.LabelAt(filled, 0.08F, 1), 0);  // the table beside it
}

TEST(FillHollows, LeavesWhatHasNoRimForMostOfItsCircle) {
  const HollowCup cup;
  EXPECT_NE(cup.LabelAt(cup.Fill(PointsAt(0.9F)), 0, 1.02F), 0);  // a rim in front of it
  cv::Mat beyond = PointsAt(3);  // one sees through where a rim would be …
  EXPECT_EQ(cup.LabelAt(cup.Fill(beyond), 0, 1.02F), 0);
  beyond.colRange(0, 34).setTo(cv::Scalar(0, 0, 0.9));  // … but for its left half
  EXPECT_NE(cup.LabelAt(cup.Fill(beyond), 0, 1.02F), 0);
}

TEST(FillHollows, LeavesTheOutsideOfRoundThings) {
  const HollowCup cylinder(-1);
  EXPECT_EQ(cylinder.Fill(), cylinder.labels);
}

TEST(FillHollows, LeavesWallsOfTheRoom) {
  HollowCup cup;
  cup.on_wall.assign(cup.labels.size(), 1);
  EXPECT_EQ(cup.LabelAt(cup.Fill(), 0, 1.02F), 0);
}

TEST(FillHollows, FillsOnlyWhatIsConnectedWithTheInside) {
  HollowCup cup;
  std::erase_if(cup.grid.edges, [&](const VoxelEdge& edge) {
    return (cup.labels[edge.a] == 0) != (cup.labels[edge.b] == 0);
  });
  EXPECT_EQ(cup.LabelAt(cup.Fill(), 0, 1.02F), 0);
}

TEST(FillHollows, LeavesWhatRunsOutIntoTheBackground) {
  HollowCup cup;
  for (int degree = 0; degree < 360; degree += 5) {  // a table all below the wall
    const float angle = static_cast<float>(degree) * std::numbers::pi_v<float> / 180;
    for (const float radius : {0.045F, 0.05F, 0.055F, 0.06F}) {
      cup.Add(radius * std::cos(angle), 0.005F, 1 + radius * std::sin(angle), kUp, 0);
    }
  }
  cup.Connect();
  cup.objects = cup.labels;
  EXPECT_EQ(cup.LabelAt(cup.Fill(), 0, 1.02F), 0);
}

TEST(FillHollows, LeavesThingsWithoutWalls) {
  const HollowCup cup;
  EXPECT_EQ(cup.Fill(kUnmeasured, 0), cup.labels);
}

}  // namespace
}  // namespace fovea
