#include "core/segmentation/labels.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <opencv2/core.hpp>

#include "tests/core/segmentation/voxel_chain.h"

namespace fovea {
namespace {

TEST(SplitIntoSegments, SeparatesPartsThatDoNotTouch) {
  EXPECT_EQ(SplitIntoSegments(Chain(7), {5, 5, 0, 5, 2, 2, 0}),
            (std::vector<int>{1, 1, 0, 2, 3, 3, 0}));
}

TEST(SplitIntoSegments, FollowsEdgesNotOrder) {
  VoxelGrid grid = Chain(5);
  grid.edges = {{0, 4}, {1, 3}};
  EXPECT_EQ(SplitIntoSegments(grid, {9, 9, 9, 9, 9}), (std::vector<int>{1, 2, 3, 2, 1}));
}

TEST(SplitIntoSegments, BackgroundStays) {
  EXPECT_EQ(SplitIntoSegments(Chain(3), {0, 0, 0}), (std::vector<int>{0, 0, 0}));
  EXPECT_TRUE(SplitIntoSegments(Chain(0), {}).empty());
}

TEST(Renumbered, NumbersSetsInOrderOfTheirFirstVoxel) {
  DisjointSets sets(6);
  sets.Join(5, 2);
  sets.Join(3, 4);
  EXPECT_EQ(Renumbered({4, 0, 5, 1, 3, 2}, sets), (std::vector<int>{1, 0, 2, 3, 1, 2}));
}

TEST(IsInterior, NeedsEightNeighboursOfTheSameLabel) {
  cv::Mat labels = cv::Mat::zeros(6, 6, CV_16UC1);
  labels(cv::Rect(1, 1, 4, 4)).setTo(3);
  EXPECT_TRUE(IsInterior(labels, 2, 3));
  EXPECT_FALSE(IsInterior(labels, 1, 3));
  labels.at<std::uint16_t>(1, 2) = 4;  // a corner away
  EXPECT_FALSE(IsInterior(labels, 2, 3));
  labels.setTo(3);
  EXPECT_FALSE(IsInterior(labels, 0, 3));  // at the end of the image
}

TEST(LabelImage, GivesEachPixelTheLabelOfItsVoxel) {
  VoxelGrid grid = Chain(3);
  grid.voxel_of_pixel = (cv::Mat_<int>(2, 3) << 0, -1, 2, 1, 1, -1);
  const cv::Mat image = LabelImage(grid, {7, 0, 65535});
  ASSERT_EQ(image.type(), CV_16UC1);
  ASSERT_EQ(image.size(), cv::Size(3, 2));
  const cv::Mat expected = (cv::Mat_<std::uint16_t>(2, 3) << 7, 0, 65535, 0, 0, 0);
  EXPECT_EQ(cv::countNonZero(image != expected), 0) << image;
}

TEST(IndicesOfLabels, AscendAndHaveNoneOfTheBackground) {
  const Lists<int> indices = IndicesOfLabels({0, 2, 3, 0, 2});
  ASSERT_EQ(indices.size(), 4U);
  EXPECT_TRUE(indices[0].empty());
  EXPECT_TRUE(indices[1].empty());
  ASSERT_EQ(indices[2].size(), 2U);
  EXPECT_EQ(indices[2][0], 1);
  EXPECT_EQ(indices[2][1], 4);
  ASSERT_EQ(indices[3].size(), 1U);
  EXPECT_EQ(indices[3][0], 2);
}

TEST(CountLabels, IsTheHighest) {
  EXPECT_EQ(CountLabels({}), 0U);
  EXPECT_EQ(CountLabels({0, 0}), 0U);
  EXPECT_EQ(CountLabels({2, 0, 3, 1}), 3U);
  EXPECT_EQ(CountLabels({0, 5}), 5U);  // also where numbers are missing
}

}  // namespace
}  // namespace fovea
