#include "core/segmentation/voxel_grid.h"

#include <gtest/gtest.h>
#include <pcl/filters/voxel_grid.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace fovea {
namespace {

cv::Mat RandomPoints(unsigned seed, int rows, int cols) {
  std::mt19937 random(seed);
  cv::Mat points(rows, cols, CV_32FC3);
  for (auto it = points.begin<cv::Vec3f>(); it != points.end<cv::Vec3f>(); ++it) {
    for (int axis = 0; axis < 3; ++axis) {
      (*it)[axis] = static_cast<float>(random() % 100000) / 1e6F - 0.05F;
    }
    if (random() % 10 == 0) *it = cv::Vec3f::all(std::numeric_limits<float>::quiet_NaN());
  }
  return points;
}

cv::Mat Upwards(const cv::Mat& points) {
  return cv::Mat(points.size(), CV_32FC3, cv::Scalar(0, -1, 0));
}

bool AreNeighbors(const Voxel& a, const Voxel& b, int axes) {
  const Eigen::Vector3i d = (a.cell - b.cell).cwiseAbs();
  return d.maxCoeff() == 1 && d.sum() <= axes;
}

TEST(BuildVoxelGrid, HasTheCentroidsOfPclsVoxelGrid) {
  const cv::Mat points = RandomPoints(1, 30, 40);
  const VoxelGrid grid = BuildVoxelGrid(points, {Upwards(points)}, {.size_m = 0.01});

  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (auto it = points.begin<cv::Vec3f>(); it != points.end<cv::Vec3f>(); ++it) {
    if (!std::isnan((*it)[2])) cloud->push_back({(*it)[0], (*it)[1], (*it)[2]});
  }
  pcl::VoxelGrid<pcl::PointXYZ> filter;
  filter.setInputCloud(cloud);
  filter.setLeafSize(0.01F, 0.01F, 0.01F);
  pcl::PointCloud<pcl::PointXYZ> expected;
  filter.filter(expected);

  ASSERT_EQ(grid.voxels.size(), expected.size());
  for (const pcl::PointXYZ& p : expected) {
    const bool found = std::any_of(grid.voxels.begin(), grid.voxels.end(), [&](const Voxel& v) {
      return (v.mean - p.getVector3fMap()).norm() < 1e-5F;
    });
    EXPECT_TRUE(found) << p;
  }
}

TEST(BuildVoxelGrid, ConnectsExactlyTheNeighborsOfEachKind) {
  const cv::Mat points = RandomPoints(2, 20, 20);
  for (const int axes : {1, 2, 3}) {
    const VoxelGrid grid =
        BuildVoxelGrid(points, {Upwards(points)}, {.size_m = 0.015, .neighbor_axes = axes});
    std::set<std::pair<int, int>> expected;
    for (int a = 0; a < static_cast<int>(grid.voxels.size()); ++a) {
      for (int b = a + 1; b < static_cast<int>(grid.voxels.size()); ++b) {
        if (AreNeighbors(grid.voxels[a], grid.voxels[b], axes)) expected.emplace(a, b);
      }
    }
    std::set<std::pair<int, int>> actual;
    for (const VoxelEdge& edge : grid.edges) actual.emplace(edge.a, edge.b);
    EXPECT_EQ(actual, expected) << axes;
    EXPECT_EQ(actual.size(), grid.edges.size()) << "an edge is there twice";
  }
}

TEST(BuildVoxelGrid, TellsTheVoxelOfEachPixel) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const cv::Mat points =
      cv::Mat(
          std::vector<cv::Vec3f>{{0.001F, 0, 1}, {nan, nan, nan}, {0.002F, 0, 1}, {-0.001F, 0, 1}},
          true)
          .reshape(3, 1);
  const VoxelGrid grid = BuildVoxelGrid(points, {Upwards(points)}, {.size_m = 0.01});
  EXPECT_EQ(grid.voxels.size(), 2U);
  EXPECT_EQ(grid.voxel_of_pixel.at<int>(0), 0);
  EXPECT_EQ(grid.voxel_of_pixel.at<int>(1), -1);
  EXPECT_EQ(grid.voxel_of_pixel.at<int>(2), 0);
  EXPECT_EQ(grid.voxel_of_pixel.at<int>(3), 1);
  EXPECT_EQ(grid.voxels[0].num_points, 2);
  EXPECT_FLOAT_EQ(grid.voxels[0].mean.x(), 0.0015F);
  EXPECT_EQ(grid.voxels[0].normal, Eigen::Vector3f(0, -1, 0));
}

// What a camera of 100 px focal length sees of a wall across its axis; the axis pierces the upper
// left corner of the image.
cv::Mat WallAt(float z) {
  cv::Mat points(20, 20, CV_32FC3);
  for (int row = 0; row < 20; ++row) {
    for (int col = 0; col < 20; ++col) {
      const float x = (static_cast<float>(col) + 0.5F) / 100;
      const float y = (static_cast<float>(row) + 0.5F) / 100;
      points.at<cv::Vec3f>(row, col) = {x * z, y * z, z};
    }
  }
  return points;
}

// Of the 64 columns three would lie on faces of the cells: 330 - 319.5 is twice 525 · 0.01.
TEST(BuildVoxelGrid, ColumnsOnAFaceOfPerspectiveVoxelsStayWhole) {
  cv::Mat points(200, 64, CV_32FC3);
  for (int row = 0; row < points.rows; ++row) {
    const float z = 0.5F + 0.001F * static_cast<float>(row);
    for (int col = 0; col < points.cols; ++col) {
      const auto ray = static_cast<float>((col + 300 - 319.5) / 525);
      points.at<cv::Vec3f>(row, col) = {z * ray, 0, z};
    }
  }
  const VoxelGrid grid =
      BuildVoxelGrid(points, {Upwards(points)}, {.size_m = 0.01, .perspective = true});
  const auto cell = [&](int row, int col) {
    return grid.voxels[grid.voxel_of_pixel.at<int>(row, col)].cell.x();
  };
  for (int col = 0; col < points.cols; ++col) {
    for (int row = 1; row < points.rows; ++row) ASSERT_EQ(cell(row, col), cell(0, col)) << col;
  }
  EXPECT_EQ(cell(0, 29), 1);
  EXPECT_EQ(cell(0, 30), 2);
  EXPECT_EQ(cell(0, 9), -3);
  EXPECT_EQ(cell(0, 10), -2);
}

TEST(BuildVoxelGrid, PerspectiveVoxelsHoldTheSameNumberOfPixelsAtAnyDistance) {
  for (const float z : {0.6F, 1.01F, 2.02F, 5.05F}) {
    const cv::Mat points = WallAt(z);
    const VoxelGrid grid =
        BuildVoxelGrid(points, {Upwards(points)}, {.size_m = 0.05, .perspective = true});
    EXPECT_EQ(grid.voxels.size(), 16U) << z;  // 0.05 rad · 100 px = 5 px
    for (const Voxel& voxel : grid.voxels) EXPECT_EQ(voxel.num_points, 25) << z;
  }
  const cv::Mat far = WallAt(2.02F);  // 20 px are 40 cm: 8 voxels of 5 cm a side
  EXPECT_EQ(BuildVoxelGrid(far, {Upwards(far)}, {.size_m = 0.05}).voxels.size(), 64U);
}

TEST(BuildVoxelGrid, PerspectiveVoxelsGrowAlongTheAxisToo) {
  const auto at = [](double steps) {
    return cv::Vec3f(0, 0, static_cast<float>(std::exp(0.05 * steps)));
  };
  for (const double k : {-10.0, 0.0, 22.0}) {  // 0.6 m, 1 m, 3 m
    const std::vector<cv::Vec3f> axis{at(k + 0.1), at(k + 0.9), at(k + 1.1)};
    const cv::Mat points = cv::Mat(axis, true).reshape(3, 1);
    const VoxelGrid grid =
        BuildVoxelGrid(points, {Upwards(points)}, {.size_m = 0.05, .perspective = true});
    ASSERT_EQ(grid.voxels.size(), 2U) << k;
    EXPECT_EQ(grid.voxels[0].num_points, 2) << k;
    EXPECT_EQ(grid.edges.size(), 1U) << k;
  }
}

TEST(BuildVoxelGrid, IsEmptyWithoutPoints) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const cv::Mat none(2, 2, CV_32FC3, cv::Scalar::all(nan));
  const VoxelGrid grid = BuildVoxelGrid(none, {none});
  EXPECT_TRUE(grid.voxels.empty());
  EXPECT_TRUE(grid.edges.empty());
}

TEST(BuildVoxelGrid, VoxelsKnowTheirFirstPixel) {
  const cv::Mat wall = WallAt(2.02F);
  const VoxelGrid grid = BuildVoxelGrid(wall, {Upwards(wall)}, {.size_m = 0.05});
  std::vector<cv::Point> first(grid.voxels.size(), {-1, -1});
  for (int row = wall.rows - 1; row >= 0; --row) {
    for (int col = wall.cols - 1; col >= 0; --col) {
      first[grid.voxel_of_pixel.at<int>(row, col)] = {col, row};
    }
  }
  for (std::size_t v = 0; v < first.size(); ++v) EXPECT_EQ(grid.voxels[v].first_px, first[v]) << v;
}

TEST(EdgesWithin, HaveBothEndsInTheSet) {
  VoxelGrid grid;
  grid.edges = {{0, 1}, {1, 2}, {2, 3}};
  const std::vector<VoxelEdge> edges = EdgesWithin(grid, {1, 0, 0, 1}, 0);
  ASSERT_EQ(edges.size(), 1U);
  EXPECT_EQ(edges[0].a, 1);
  EXPECT_EQ(edges[0].b, 2);
  EXPECT_TRUE(EdgesWithin(grid, {1, 0, 0, 1}, 1).empty());
}

}  // namespace
}  // namespace fovea
