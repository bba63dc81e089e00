#include "core/segmentation/part_merge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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
  scene.grid = BuildVoxelGrid(points, {normals}, {.size_m = 0.01});
  for (const Voxel& voxel : scene.grid.voxels) scene.labels.push_back(voxel.mean.x() < 0 ? 1 : 2);
  return scene;
}

constexpr PartMergeOptions kOptions{.min_probability = 0.5};
constexpr CameraIntrinsics kCamera{100, 100, 19.5, 9.5};  // a pixel is a centimetre at 1 m
const Eigen::Vector3f kUp(0, -1, 0);

const cv::Vec3b kGrey(100, 100, 100);
const cv::Vec3b kWhite(255, 255, 255);

std::vector<MeanColor> ColorsOf(const Scene& scene) {
  return ColorsOfVoxels(scene.grid, std::vector<char>(scene.labels.size(), 0), scene.color);
}

std::size_t SegmentsLeft(const Scene& scene, const PartMergeOptions& options) {
  const auto colors = ColorsOf(scene);
  const auto merged = MergeParts(scene.grid, scene.labels, colors, kCamera, kUp, options);
  return static_cast<std::size_t>(*std::max_element(merged.begin(), merged.end()));
}

TEST(MergeParts, JoinsOneEvenSurfaceAndKeepsGroovesApart) {
  EXPECT_EQ(SegmentsLeft(TwoFaces(0, kGrey), kOptions), 1U);
  EXPECT_EQ(SegmentsLeft(TwoFaces(-1, kWhite), kOptions), 2U);
}

TEST(MergeParts, IsOffAtOne) {
  EXPECT_EQ(SegmentsLeft(TwoFaces(0, kGrey), {.min_probability = 1}), 2U);
}

TEST(MergeParts, DoesNotTouchTheBackground) {
  Scene scene = TwoFaces(0, kGrey);
  std::replace(scene.labels.begin(), scene.labels.end(), 2, 0);
  const auto colors = ColorsOf(scene);
  EXPECT_EQ(MergeParts(scene.grid, scene.labels, colors, kCamera, kUp, kOptions), scene.labels);
}

SegmentGraph GraphOf(const Scene& scene) {
  return {scene.grid, scene.labels, ColorsOf(scene), kCamera, kUp};
}

Kinship KinshipIn(const Scene& scene) { return GraphOf(scene).Pairs().at({1, 2}); }

TEST(MergeParts, JoinsWhatIsLikelyEnough) {
  const Scene groove = TwoFaces(-1, kWhite);
  const double probability = 1 / (1 + std::exp(-LogOdds(KinshipIn(groove))));
  EXPECT_EQ(SegmentsLeft(groove, {.min_probability = 0.99 * probability}), 1U);
  EXPECT_EQ(SegmentsLeft(groove, {.min_probability = 1.01 * probability}), 2U);
}

TEST(KinshipOf, MeasuresWhatSpeaksForOneObject) {
  const Kinship flat = KinshipIn(TwoFaces(0, kGrey));
  EXPECT_NEAR(flat.unevenness, 0, 1e-6);
  EXPECT_NEAR(flat.color_likeness, 1, 1e-6);
  EXPECT_NEAR(flat.top_step, 0, 1e-6);
  EXPECT_NEAR(flat.height_m, 0.19, 1e-6);            // between the centres of 20 rows
  EXPECT_NEAR(flat.log_area, std::log(0.08), 0.02);  // 20 × 40 pixels at 1.005 m
  EXPECT_NEAR(flat.distance_m, 1.005, 1e-6);
  EXPECT_NEAR(flat.flatness, std::exp(-0.19 / 0.025), 1e-6);
  EXPECT_NEAR(flat.convexity_deg, 0, 1e-6);
  EXPECT_NEAR(flat.color_continuity, 1, 1e-6);
}

TEST(KinshipOf, TellsEdgesFromGrooves) {
  EXPECT_GT(KinshipIn(TwoFaces(1, kGrey)).convexity_deg, 30);  // 45° less the flatness
  EXPECT_LT(KinshipIn(TwoFaces(-1, kGrey)).convexity_deg, -30);
}

TEST(KinshipOf, GroovesOfWhatIsFlatCountLittle) {
  Scene scene = TwoFaces(-1, kGrey);
  for (std::size_t v = 0; v < scene.labels.size(); ++v) {  // of the right face only two rows
    const Voxel& voxel = scene.grid.voxels[v];
    if (scene.labels[v] == 2 && voxel.mean.y() > 0.02F) scene.labels[v] = 0;
  }
  const Kinship kinship = KinshipIn(scene);
  EXPECT_NEAR(kinship.flatness, std::exp(-0.01 / 0.025), 1e-4);
  EXPECT_GT(kinship.convexity_deg, -45 * (1 - kinship.flatness) - 1);
}

TEST(KinshipOf, ColorGoesOnWhereOnlyTheMeansDiffer) {
  Scene scene = TwoFaces(0, kWhite);
  scene.color.col(20).setTo(cv::Scalar(100, 100, 100));  // the right face begins in the left's grey
  const Kinship kinship = KinshipIn(scene);
  EXPECT_NEAR(kinship.color_continuity, 1, 1e-6);
  EXPECT_LT(kinship.color_likeness, 0.05);
  EXPECT_LT(KinshipIn(TwoFaces(0, kWhite)).color_continuity, 1e-4);
}

TEST(KinshipOf, FallsWithBendsAndDifferencesOfColor) {
  const Kinship flat = KinshipIn(TwoFaces(0, kGrey));
  const Kinship groove = KinshipIn(TwoFaces(-1, kGrey));
  const Kinship edge = KinshipIn(TwoFaces(1, kGrey));
  EXPECT_GT(groove.unevenness, 0.8);  // 45°
  EXPECT_NEAR(groove.unevenness, edge.unevenness, 0.05);
  EXPECT_LT(LogOdds(groove), LogOdds(flat));
  // L* 42.4 and 50.4; differences count 1.75 times where all is grey.
  const Kinship two_colors = KinshipIn(TwoFaces(0, {120, 120, 120}));
  EXPECT_NEAR(two_colors.color_likeness, std::exp(-1.75 * 8.06 / 12), 0.03);
  EXPECT_LT(LogOdds(two_colors), LogOdds(flat));
}

TEST(KinshipOf, SeesTheStepBetweenTheTops) {
  Scene scene = TwoFaces(0, kGrey);
  for (std::size_t v = 0; v < scene.labels.size(); ++v) {  // the right face begins 10 rows lower
    const Voxel& voxel = scene.grid.voxels[v];
    if (scene.labels[v] == 2 && voxel.mean.y() < 0.1F) scene.labels[v] = 0;
  }
  EXPECT_NEAR(KinshipIn(scene).top_step, 0.1 / 0.19, 1e-3);
}

// Of the right face only what lies beyond `min_m` along an axis.
Scene WithRightFaceFrom(int axis, float min_m) {
  Scene scene = TwoFaces(0, kGrey);
  for (std::size_t v = 0; v < scene.labels.size(); ++v) {
    if (scene.labels[v] == 2 && scene.grid.voxels[v].mean[axis] < min_m) scene.labels[v] = 0;
  }
  return scene;
}

TEST(KinshipOf, ComparesSizes) {
  const Kinship equal = KinshipIn(TwoFaces(0, kGrey));
  EXPECT_NEAR(equal.log_area_ratio, 0, 1e-6);
  EXPECT_NEAR(equal.log_smaller_area, std::log(0.04), 0.02);
  // 20 voxels meet 20, each of them up to three of the other side.
  EXPECT_NEAR(equal.contact, std::log(58 / std::sqrt(400)), 1e-6);
  const Kinship half = KinshipIn(WithRightFaceFrom(1, 0.1F));
  EXPECT_NEAR(half.log_area_ratio, std::log(0.5), 1e-6);
  EXPECT_NEAR(half.log_smaller_area, std::log(0.02), 0.02);
}

TEST(KinshipOf, ComparesExtents) {
  const Kinship beside = KinshipIn(TwoFaces(0, kGrey));  // of 39 cm, from 0 and from 20
  EXPECT_NEAR(beside.side_step, 20.0 / 39, 1e-3);
  EXPECT_NEAR(beside.height_overlap, 1, 1e-3);
  EXPECT_NEAR(beside.rise, 38.0 / 96, 1e-3);  // 20 pairs go straight across, 38 at 45 degrees
  EXPECT_NEAR(KinshipIn(WithRightFaceFrom(1, 0.1F)).height_overlap, 9.0 / 19, 1e-3);

  Scene stacked = TwoFaces(0, kGrey);  // the lower face is 5 cm less wide, on one side
  for (std::size_t v = 0; v < stacked.labels.size(); ++v) {
    const Eigen::Vector3f& mean = stacked.grid.voxels[v].mean;
    stacked.labels[v] = mean.y() < 0.1F ? 1 : mean.x() < 0.15F ? 2 : 0;
  }
  const Kinship kinship = KinshipIn(stacked);
  EXPECT_NEAR(kinship.side_step, 0, 1e-3);
  EXPECT_NEAR(kinship.height_overlap, 0, 1e-3);
  EXPECT_GT(kinship.rise, 0.5);
}

TEST(KinshipOf, SeesWhatLiesBehind) {
  const Kinship sloped = KinshipIn(TwoFaces(1, kGrey));  // away from z = 1 over 20 cm
  EXPECT_NEAR(sloped.depth_overlap, 0, 0.05);
}

TEST(KinshipOf, KnowsNoDistanceBeyondThatOfItsFit) {
  Scene scene = TwoFaces(0, kGrey);
  for (Voxel& voxel : scene.grid.voxels) voxel.mean.z() += 6;
  EXPECT_EQ(KinshipIn(scene).distance_m, 3);
}

TEST(SegmentGraph, AddsUpWhatItJoins) {
  Scene scene = TwoFaces(0, kGrey);
  for (std::size_t v = 0; v < scene.labels.size(); ++v) {  // a third one in the lower right
    const Voxel& voxel = scene.grid.voxels[v];
    if (scene.labels[v] == 2 && voxel.mean.y() > 0.1F) scene.labels[v] = 3;
  }
  SegmentGraph graph = GraphOf(scene);
  ASSERT_EQ(graph.Pairs().size(), 3U);
  graph.Join({2, 3});
  ASSERT_EQ(graph.Pairs().size(), 1U);
  EXPECT_EQ(graph.Objects().Find(3), 2);
  const KinshipTerms joined = TermsOf(graph.Pairs().at({1, 2}));
  const KinshipTerms whole = TermsOf(KinshipIn(TwoFaces(0, kGrey)));
  for (std::size_t i = 0; i < kNumKinshipTerms; ++i) {
    EXPECT_NEAR(joined[i], whole[i], 1e-9) << KinshipTermNames()[i];
  }
}

TEST(CollectBoundaries, BridgesGapsOfOneVoxelWhereNothingTouches) {
  for (const int gap : {0, 1, 2}) {
    Scene scene = TwoFaces(0, kGrey);
    for (std::size_t v = 0; v < scene.labels.size(); ++v) {  // the right face begins later
      const float x = scene.grid.voxels[v].mean.x();
      if (x > 0 && x < 0.01F * static_cast<float>(gap)) scene.labels[v] = 0;
    }
    EXPECT_EQ(GraphOf(scene).Pairs().count({1, 2}), gap < 2 ? 1U : 0U) << gap;
  }
  Scene corner = TwoFaces(0, kGrey);  // of the right face only one voxel, beyond a gap
  for (std::size_t v = 0; v < corner.labels.size(); ++v) {
    const Eigen::Vector3f& mean = corner.grid.voxels[v].mean;
    const bool stays = mean.x() > 0.01F && mean.x() < 0.02F && mean.y() < 0.01F;
    if (corner.labels[v] == 2 && !stays) corner.labels[v] = 0;
  }
  EXPECT_TRUE(GraphOf(corner).Pairs().empty());
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
