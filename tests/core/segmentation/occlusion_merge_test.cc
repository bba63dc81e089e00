#include "core/segmentation/occlusion_merge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <opencv2/core.hpp>
#include <vector>

#include "core/types/lab.h"

namespace fovea {
namespace {

const Eigen::Vector3f kSceneUp = -Eigen::Vector3f::UnitY();
const CameraIntrinsics kIntrinsics{.fx_px = 200, .fy_px = 200, .cx_px = 0, .cy_px = 0};
const cv::Vec3b kGrey(100, 100, 100);
const cv::Vec3b kLightGrey(200, 200, 200);
const cv::Vec3b kRed(200, 40, 30);

struct Pixel {
  cv::Vec3f point;
  cv::Vec3f normal = {0, 0, -1};
  int label = 0;
  cv::Vec3b color = kGrey;
};

struct SceneOfPixels {
  VoxelGrid grid;
  std::vector<int> labels;
  cv::Mat points;
  cv::Mat color;
};

SceneOfPixels MakeScene(int rows, int cols,
                        const std::function<Pixel(int row, int col)>& pixel_at) {
  SceneOfPixels scene;
  scene.points = cv::Mat(rows, cols, CV_32FC3);
  scene.color = cv::Mat(rows, cols, CV_8UC3);
  cv::Mat normals(rows, cols, CV_32FC3);
  cv::Mat labels(rows, cols, CV_32SC1);
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      const Pixel pixel = pixel_at(row, col);
      scene.points.at<cv::Vec3f>(row, col) = pixel.point;
      scene.color.at<cv::Vec3b>(row, col) = pixel.color;
      normals.at<cv::Vec3f>(row, col) = pixel.normal;
      labels.at<int>(row, col) = pixel.label;
    }
  }
  scene.grid = BuildVoxelGrid(scene.points, {normals}, {.size_m = 0.01});
  scene.labels.resize(scene.grid.voxels.size());
  for (int i = 0; i < rows * cols; ++i) {
    const int voxel = scene.grid.voxel_of_pixel.at<int>(i / cols, i % cols);
    if (voxel >= 0) scene.labels[voxel] = labels.at<int>(i / cols, i % cols);
  }
  return scene;
}

std::vector<int> Merge(const SceneOfPixels& scene, const OcclusionMergeOptions& options) {
  const auto colors = ColorsOfVoxels(scene.grid, LabOf(scene.color));
  return MergeOccluded(scene.grid, scene.labels, scene.points, colors, kIntrinsics, kSceneUp,
                       options);
}

// True if the merge gave both labels of the scene one number.
bool AreJoined(const SceneOfPixels& scene, int a, int b, const OcclusionMergeOptions& options) {
  const auto merged = Merge(scene, options);
  int number_a = -1;
  int number_b = -2;
  for (std::size_t v = 0; v < merged.size(); ++v) {
    if (scene.labels[v] == a) number_a = merged[v];
    if (scene.labels[v] == b) number_b = merged[v];
  }
  return number_a == number_b;
}

constexpr int kLeft = 1;
constexpr int kOccluder = 2;
constexpr int kRight = 3;

struct Halves {
  float offset_m = 0;             // of the right half behind the left one
  cv::Vec3b right_color = kGrey;  // the left one is grey
  int occluder_rows = 40;         // it covers this many rows of the gap …
  float gap_m = 2;                // … and the others show background at this depth
};

// An upright plane at z = 1 of 40 × 120 pixels of 5 mm, its middle third hidden by something at
// z = 0.8.
SceneOfPixels HiddenMiddle(const Halves& halves) {
  return MakeScene(40, 120, [&](int row, int col) -> Pixel {
    const float x = 0.005F * (static_cast<float>(col) + 0.5F);
    const float y = 0.005F * (static_cast<float>(row) + 0.5F);
    if (col < 40) return {.point = {x, y, 1.005F}, .label = kLeft};
    if (col >= 80) {
      return {
          .point = {x, y, 1.005F + halves.offset_m}, .label = kRight, .color = halves.right_color};
    }
    if (row < halves.occluder_rows) return {.point = {x, y, 0.805F}, .label = kOccluder};
    return {.point = {x, y, halves.gap_m}};
  });
}

// The bend that the inside of something hollow needs.
constexpr OcclusionMergeOptions Hollow(double curvature_per_m) {
  return {.min_shared_surface = 0, .min_hollow_curvature_per_m = curvature_per_m};
}
constexpr OcclusionMergeOptions kHollow = Hollow(5);
constexpr OcclusionMergeOptions kBehind{.min_shared_surface = 0.5, .min_hollow_curvature_per_m = 0};

TEST(MergeOccluded, JoinsThePartsOfAPlaneBehindAnOccluder) {
  const SceneOfPixels scene = HiddenMiddle({});
  const auto merged = Merge(scene, kBehind);
  for (std::size_t v = 0; v < merged.size(); ++v) {
    EXPECT_EQ(merged[v], scene.labels[v] == kOccluder ? 2 : 1);
  }
}

TEST(MergeOccluded, KeepsPlanesApartThatAreOffset) {
  EXPECT_FALSE(AreJoined(HiddenMiddle({.offset_m = 0.03F}), kLeft, kRight, kBehind));
  EXPECT_FALSE(AreJoined(HiddenMiddle({.offset_m = 0.012F}), kLeft, kRight, kBehind));
  EXPECT_TRUE(AreJoined(HiddenMiddle({.offset_m = 0.008F}), kLeft, kRight, kBehind));
}

TEST(MergeOccluded, KeepsPlanesApartThatAreTurned) {
  SceneOfPixels scene = HiddenMiddle({});
  const auto turn_right_half = [&](float slope) {
    for (std::size_t v = 0; v < scene.labels.size(); ++v) {
      if (scene.labels[v] != kRight) continue;
      scene.grid.voxels[v].normal = Eigen::Vector3f(0, slope, -1).normalized();
    }
  };
  turn_right_half(0.4F);  // 22°
  EXPECT_FALSE(AreJoined(scene, kLeft, kRight, kBehind));
  turn_right_half(0.2F);  // 11°
  EXPECT_TRUE(AreJoined(scene, kLeft, kRight, kBehind));
}

TEST(MergeOccluded, KeepsDifferentColorsApart) {
  EXPECT_FALSE(AreJoined(HiddenMiddle({.right_color = kRed}), kLeft, kRight, kBehind));
  EXPECT_TRUE(AreJoined(HiddenMiddle({.right_color = kLightGrey}), kLeft, kRight, kBehind));
}

TEST(MergeOccluded, KeepsPartsApartBetweenWhichTheBackgroundIsSeen) {
  EXPECT_FALSE(AreJoined(HiddenMiddle({.occluder_rows = 10}), kLeft, kRight, kBehind));
}

TEST(MergeOccluded, AGapWithoutDepthDoesNotPart) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(AreJoined(HiddenMiddle({.occluder_rows = 10, .gap_m = nan}), kLeft, kRight, kBehind));
}

TEST(MergeOccluded, NeedsAnOccluder) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(AreJoined(HiddenMiddle({.occluder_rows = 0, .gap_m = nan}), kLeft, kRight, kBehind));
}

TEST(MergeOccluded, IsOffAtZero) {
  const SceneOfPixels scene = HiddenMiddle({});
  EXPECT_EQ(Merge(scene, Hollow(0)), scene.labels);
  EXPECT_EQ(Merge(scene, kHollow), scene.labels);
}

constexpr int kInside = 1;
constexpr int kOutside = 2;

// An upright cup of radius 4 cm at z = 1, seen from above its rim: the upper rows show 2 cm of the
// far wall's inside, the lower rows the near wall's outside. `back_sign` -1 bends the far wall
// towards the camera instead; it is raised by `lift_m`.
SceneOfPixels Cup(float back_sign = 1, float lift_m = 0) {
  constexpr float kRadius = 0.04F;
  return MakeScene(60, 78, [&](int row, int col) -> Pixel {
    const float x = 0.001F * (static_cast<float>(col) - 38.5F);
    const float depth = std::sqrt(kRadius * kRadius - x * x);
    if (row < 20) {
      return {.point = {x, 0.001F * static_cast<float>(row) - lift_m,
                        back_sign > 0 ? 1 + depth : 1.08F - depth},
              .normal = cv::Vec3f(-back_sign * x, 0, -depth) / kRadius,
              .label = kInside};
    }
    return {.point = {x, 0.001F * static_cast<float>(row - 20), 1 - depth},
            .normal = cv::Vec3f(x, 0, -depth) / kRadius,
            .label = kOutside};
  });
}

TEST(MergeOccluded, JoinsTheInsideOfACupWithItsOutside) {
  EXPECT_TRUE(AreJoined(Cup(), kInside, kOutside, kHollow));
}

TEST(MergeOccluded, KeepsWhatBulgesBehindApart) {
  EXPECT_FALSE(AreJoined(Cup(-1), kInside, kOutside, kHollow));
}

TEST(MergeOccluded, InsideAndOutsideShareARim) {
  EXPECT_TRUE(AreJoined(Cup(1, 0.01F), kInside, kOutside, kHollow));
  EXPECT_FALSE(AreJoined(Cup(1, 0.05F), kInside, kOutside, kHollow));
}

TEST(MergeOccluded, WhatStandsBesideACupIsNotItsOutside) {
  SceneOfPixels scene = Cup();
  for (Voxel& voxel : scene.grid.voxels) {  // the outer wall, moved aside by half its width
    if (voxel.mean.z() < 1 - 0.001F) voxel.mean.x() += 0.04F;
  }
  EXPECT_FALSE(AreJoined(scene, kInside, kOutside, kHollow));
}

TEST(MergeOccluded, WhatFacesTheAxisOfACupIsNotItsOutside) {
  SceneOfPixels scene = Cup();
  for (Voxel& voxel : scene.grid.voxels) {  // the outer wall, moved behind the axis
    if (voxel.mean.z() < 1 - 0.001F) voxel.mean.z() += 0.06F;
  }
  EXPECT_FALSE(AreJoined(scene, kInside, kOutside, kHollow));
}

TEST(MergeOccluded, TheInsideBendsAtLeastAsMuchAsAsked) {
  // The radius of 4 cm is a curvature of 25/m.
  EXPECT_TRUE(AreJoined(Cup(), kInside, kOutside, Hollow(24)));
  EXPECT_FALSE(AreJoined(Cup(), kInside, kOutside, Hollow(26)));
}

TEST(MergeOccluded, HollowIsOffAtZero) {
  EXPECT_FALSE(AreJoined(Cup(), kInside, kOutside, kBehind));
}

}  // namespace
}  // namespace fovea
