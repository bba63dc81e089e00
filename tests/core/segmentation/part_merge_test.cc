#include "core/segmentation/shape_merge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/core.hpp>

namespace fovea {
namespace {

struct Scene {
  VoxelGrid grid;
  std::vector<int> labels;
  cv::Mat color;
};

// Two square faces of 20×20 voxels that meet along y: labels 1 and 2. The left one lies at
// z = 1; the right one runs on from its edge with the slope dz/dx and has the given colour.
Scene TwoFaces(float slope, const cv::Vec3b& right_color) {
  cv::Mat points(20, 40, CV_32FC3);
  cv::Mat normals(20, 40, CV_32FC3);
  Scene scene;
  scene.color = cv::Mat(20, 40, CV_8UC3, cv::Scalar(100, 100, 100));
  for (int row = 0; row < 20; ++row) {
    for (int col = 0; col < 40; ++col) {
      const float x = (static_cast<float>(col) - 19.5F) * 0.01F;
      const bool right = col >= 20;
      points.at<cv::Vec3f>(row, col) = {x, 0.01F * static_cast<float>(row) + 0.005F,
                                        right ? 1.005F + slope * x : 1.005F};
      normals.at<cv::Vec3f>(row, col) =
          right ? cv::normalize(cv::Vec3f(slope, 0, -1)) : cv::Vec3f(0, 0, -1);
      if (right) scene.color.at<cv::Vec3b>(row, col) = right_color;
    }
  }
  scene.grid = BuildVoxelGrid(points, normals, {.size_m = 0.01});
  for (const Voxel& voxel : scene.grid.voxels) scene.labels.push_back(voxel.mean.x() < 0 ? 1 : 2);
  return scene;
}

constexpr ShapeMergeOptions kOptions{.max_concavity_deg = 12, .color_weight_deg = 0.2};

std::size_t SegmentsLeft(const Scene& scene, const ShapeMergeOptions& options) {
  const auto merged = MergeByShape(scene.grid, scene.labels, scene.color, options);
  return static_cast<std::size_t>(*std::max_element(merged.begin(), merged.end()));
}

const cv::Vec3b kGrey(100, 100, 100);
const cv::Vec3b kWhite(255, 255, 255);

TEST(MergeByShape, JoinsFlatAndConvexFacesAndKeepsConcaveOnesApart) {
  EXPECT_EQ(SegmentsLeft(TwoFaces(0, kGrey), kOptions), 1U);
  EXPECT_EQ(SegmentsLeft(TwoFaces(1, kGrey), kOptions), 1U);   // falls away: an edge
  EXPECT_EQ(SegmentsLeft(TwoFaces(-1, kGrey), kOptions), 2U);  // comes nearer: a groove
}

TEST(MergeByShape, AcceptsGroovesUpToTheLimit) {
  const Scene groove = TwoFaces(-0.3F, kGrey);  // 16.7°
  EXPECT_EQ(SegmentsLeft(groove, {.max_concavity_deg = 16}), 2U);
  EXPECT_EQ(SegmentsLeft(groove, {.max_concavity_deg = 18}), 1U);
}

TEST(MergeByShape, WeighsAColorDifferenceAgainstShape) {
  const Scene flat = TwoFaces(0, kWhite);  // L* 42 against 100
  EXPECT_EQ(SegmentsLeft(flat, {.max_concavity_deg = 12, .color_weight_deg = 0.1}), 1U);
  EXPECT_EQ(SegmentsLeft(flat, {.max_concavity_deg = 12, .color_weight_deg = 0.3}), 2U);
}

TEST(MergeByShape, IsOffAtZero) {
  EXPECT_EQ(SegmentsLeft(TwoFaces(0, kGrey), {.max_concavity_deg = 0}), 2U);
}

TEST(MergeByShape, DoesNotTouchTheBackground) {
  Scene scene = TwoFaces(0, kGrey);
  std::replace(scene.labels.begin(), scene.labels.end(), 2, 0);
  EXPECT_EQ(MergeByShape(scene.grid, scene.labels, scene.color, kOptions), scene.labels);
}

// The left face reaches the right one in its first rows only.
Scene WithContactOf(int rows) {
  Scene scene = TwoFaces(0, kGrey);
  for (std::size_t v = 0; v < scene.labels.size(); ++v) {
    const Voxel& voxel = scene.grid.voxels[v];
    const bool at_edge = voxel.mean.x() < 0 && voxel.mean.x() > -0.02F;
    if (at_edge && voxel.mean.y() > 0.01F * static_cast<float>(rows)) scene.labels[v] = 0;
  }
  return scene;
}

TEST(MergeByShape, KeepsApartWhatMerelyTouches) {
  ShapeMergeOptions options = kOptions;
  options.reach_cells = 1;
  EXPECT_EQ(SegmentsLeft(WithContactOf(2), options), 1U);
  options.min_contact = 1.8;  // of 20 voxels; each voxel of contact makes about three pairs
  EXPECT_EQ(SegmentsLeft(WithContactOf(2), options), 2U);
  EXPECT_EQ(SegmentsLeft(WithContactOf(18), options), 1U);
}

TEST(MergeByShape, JoinsAPlaneWhoseNormalsAreNoise) {
  Scene scene = TwoFaces(0, kGrey);
  for (Voxel& voxel : scene.grid.voxels) {  // as at a groove
    voxel.normal = Eigen::Vector3f(voxel.mean.x() < 0 ? 0.5F : -0.5F, 0, -1).normalized();
    voxel.mean.z() += 0.002F * static_cast<float>(voxel.cell.x() % 2);
  }
  ShapeMergeOptions options = kOptions;
  EXPECT_EQ(SegmentsLeft(scene, options), 2U);
  options.plane_noise_per_m = 0.0005;
  EXPECT_EQ(SegmentsLeft(scene, options), 2U);
  options.plane_noise_per_m = 0.006;
  EXPECT_EQ(SegmentsLeft(scene, options), 1U);
  EXPECT_EQ(SegmentsLeft(TwoFaces(-1, kGrey), options), 2U);
}

TEST(ConvexityDeg, IsTheSignedAngle) {
  const Voxel left{.mean = {0, 0, 1}, .normal = Eigen::Vector3f(-1, 0, -1).normalized()};
  const Voxel right{.mean = {0.01F, 0, 1}, .normal = Eigen::Vector3f(1, 0, -1).normalized()};
  EXPECT_NEAR(ConvexityDeg(left, right), 90, 1e-3);
  const Voxel swapped_left{.mean = left.mean, .normal = right.normal};
  const Voxel swapped_right{.mean = right.mean, .normal = left.normal};
  EXPECT_NEAR(ConvexityDeg(swapped_left, swapped_right), -90, 1e-3);
}

TEST(StepDeg, TellsAStepFromABend) {
  Voxel near;
  near.mean = {0, 0, 1};
  near.normal = {0, 0, -1};
  Voxel far = near;
  far.mean = {0.01F, 0, 1.01F};
  EXPECT_NEAR(StepDeg(near, far), -45, 1e-3);
  EXPECT_NEAR(StepDeg(far, near), 45, 1e-3);
  far.mean = {0.01F, 0, 1};
  EXPECT_NEAR(StepDeg(near, far), 0, 1e-3);
  // Two faces of a box, at the same distance from their edge.
  near.normal = Eigen::Vector3f(-1, 0, -1).normalized();
  far.normal = Eigen::Vector3f(1, 0, -1).normalized();
  EXPECT_NEAR(StepDeg(near, far), 0, 1e-3);
  far.normal = -near.normal;
  EXPECT_EQ(StepDeg(near, far), 0);
}

}  // namespace
}  // namespace fovea
