#include "core/segmentation/merge_tree.h"

#include <gtest/gtest.h>

#include <limits>
#include <opencv2/core.hpp>

#include "core/segmentation/labels.h"
#include "core/types/lab.h"

namespace fovea {
namespace {

constexpr CameraIntrinsics kCamera{100, 100, 29.5, 9.5};  // a pixel is a centimetre at 1 m
const Eigen::Vector3f kUp(0, -1, 0);

// Three faces of 20 × 20 voxels side by side, labels 1 to 3. The first two are one even surface of
// one colour, the third meets them in a groove and has another colour; nothing is measured between
// it and a fourth, far to the right.
struct Scene {
  Scene() {
    cv::Mat points(20, 90, CV_32FC3), normals(20, 90, CV_32FC3);
    cv::Mat color(20, 90, CV_8UC3, cv::Scalar(100, 100, 100));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (int row = 0; row < 20; ++row) {
      for (int col = 0; col < 90; ++col) {
        const float x = 0.01F * static_cast<float>(col) + 0.005F;
        const float y = 0.01F * static_cast<float>(row) + 0.005F;
        const bool is_third = col >= 40 && col < 60, is_gap = col >= 60 && col < 70;
        const float z = is_third ? 1.005F - (x - 0.4F) : 1.005F;
        points.at<cv::Vec3f>(row, col) = {x, y, is_gap ? nan : z};
        normals.at<cv::Vec3f>(row, col) =
            is_third ? cv::normalize(cv::Vec3f(-1, 0, -1)) : cv::Vec3f(0, 0, -1);
        if (is_third) color.at<cv::Vec3b>(row, col) = {255, 30, 30};
      }
    }
    grid = BuildVoxelGrid(points, {normals}, {.size_m = 0.01});
    for (const Voxel& voxel : grid.voxels) {
      const float x = voxel.mean.x();
      labels.push_back(x < 0.2F ? 1 : x < 0.4F ? 2 : x < 0.65F ? 3 : 4);
    }
    colors = ColorsOfVoxels(grid, LabOf(color));
  }

  MergeTree Tree(double min_log_odds, const FindSeparate& find_separate) const {
    return BuildMergeTree(SegmentGraph(grid, labels, colors, kCamera, kUp), labels, min_log_odds,
                          find_separate);
  }

  VoxelGrid grid;
  std::vector<int> labels;
  std::vector<MeanColor> colors;
};

std::vector<int> NothingSeparate(const std::vector<int>& labels) { return labels; }

TEST(MergeTree, JoinsTheLikeliestFirstAndGoesOnAgainstTheOdds) {
  const MergeTree tree = Scene().Tree(-1000, NothingSeparate);
  ASSERT_EQ(tree.num_segments, 4U);
  ASSERT_EQ(tree.nodes.size(), 6U);
  EXPECT_EQ(tree.num_likely, 5U);
  EXPECT_EQ(tree.nodes[4].left, 0);
  EXPECT_EQ(tree.nodes[4].right, 1);
  EXPECT_GT(tree.nodes[4].log_odds, 0);
  EXPECT_EQ(tree.nodes[5].left, 4);
  EXPECT_EQ(tree.nodes[5].right, 2);
  EXPECT_LT(tree.nodes[5].log_odds, 0);
  EXPECT_EQ(LogOdds(tree.nodes[5].kinship), tree.nodes[5].log_odds);
  EXPECT_EQ(tree.nodes[0].parent, 4);
  EXPECT_EQ(tree.nodes[4].parent, 5);
  EXPECT_EQ(tree.nodes[3].parent, -1);  // touches nothing
  EXPECT_EQ(tree.LikelyNodes(), (std::vector<int>{2, 3, 4}));
}

TEST(MergeTree, StopsAtTheLeastOdds) {
  EXPECT_EQ(Scene().Tree(0, NothingSeparate).nodes.size(), 5U);
}

TEST(MergeTree, TakesWhatIsOneWithoutTouching) {
  const Scene scene;
  const auto join_third_and_fourth = [&](const std::vector<int>& objects) {
    EXPECT_EQ(CountLabels(objects), 3U);  // the first two are joined by then
    std::vector<int> joined = objects;
    for (int& label : joined) label = label == 3 ? 2 : label;
    return joined;
  };
  const MergeTree tree = scene.Tree(0, join_third_and_fourth);
  ASSERT_EQ(tree.nodes.size(), 6U);
  EXPECT_EQ(tree.nodes[5].left, 2);
  EXPECT_EQ(tree.nodes[5].right, 3);
  EXPECT_EQ(tree.nodes[5].log_odds, 0);
  EXPECT_EQ(tree.num_likely, 6U);
}

}  // namespace
}  // namespace fovea
