#include "core/paper/color_merge.h"

#include <gtest/gtest.h>

#include "tests/core/segmentation/voxel_chain.h"

namespace fovea::paper {
namespace {

cv::Mat Colors(const std::vector<cv::Vec3b>& colors) { return cv::Mat(colors, true).reshape(3, 1); }

const cv::Vec3b kRed(200, 10, 10);
const cv::Vec3b kBlue(10, 10, 200);

TEST(MergeByColor, JoinsNeighborsThatLookAlike) {
  EXPECT_EQ(MergeByColor(Chain(4), {1, 1, 2, 2}, Colors({kRed, kRed, kRed, kRed})),
            (std::vector<int>{1, 1, 1, 1}));
}

TEST(MergeByColor, KeepsNeighborsOfDifferentColor) {
  EXPECT_EQ(MergeByColor(Chain(4), {1, 1, 2, 2}, Colors({kRed, kRed, kBlue, kBlue})),
            (std::vector<int>{1, 1, 2, 2}));
}

TEST(MergeByColor, KeepsSegmentsApartThatDoNotTouch) {
  EXPECT_EQ(MergeByColor(Chain(3), {1, 0, 2}, Colors({kRed, kRed, kRed})),
            (std::vector<int>{1, 0, 2}));
}

TEST(MergeByColor, NumbersWhatIsLeftConsecutively) {
  EXPECT_EQ(MergeByColor(Chain(4), {1, 2, 0, 3}, Colors({kRed, kRed, kRed, kBlue})),
            (std::vector<int>{1, 1, 0, 2}));
}

// Histograms (1, 1) and (1, 0) over 8000 bins correlate by 1/√2 (but for the mean): 0.707.
TEST(MergeByColor, ComparesTheCorrelationWithItsThreshold) {
  const cv::Mat colors = Colors({kRed, kBlue, kRed, kRed});
  EXPECT_EQ(MergeByColor(Chain(4), {1, 1, 2, 2}, colors, {.min_correlation = 0.70}),
            (std::vector<int>{1, 1, 1, 1}));
  EXPECT_EQ(MergeByColor(Chain(4), {1, 1, 2, 2}, colors, {.min_correlation = 0.71}),
            (std::vector<int>{1, 1, 2, 2}));
}

// Red and blue with red beside it, then blue: which is like both together, and not like its
// neighbour.
TEST(MergeByColor, ComparesAgainWhatWasJoinedIfAsked) {
  const cv::Mat colors = Colors({kBlue, kBlue, kBlue, kRed, kRed, kRed, kBlue});
  const std::vector<int> segments = {1, 1, 1, 1, 1, 2, 3};
  EXPECT_EQ(MergeByColor(Chain(7), segments, colors), (std::vector<int>{1, 1, 1, 1, 1, 1, 2}));
  EXPECT_EQ(MergeByColor(Chain(7), segments, colors, {.iterate = true}),
            (std::vector<int>{1, 1, 1, 1, 1, 1, 1}));
}

TEST(SegmentsOf, AreLabelsOrTheirConnectedParts) {
  EXPECT_EQ(SegmentsOf(Chain(4), {3, 0, 3, 5}, {.split = false}), (std::vector<int>{1, 0, 1, 2}));
  EXPECT_EQ(SegmentsOf(Chain(4), {3, 0, 3, 5}, {.split = true}), (std::vector<int>{1, 0, 2, 3}));
}

TEST(MergeByColor, AcceptsNoSegments) {
  EXPECT_EQ(MergeByColor(Chain(2), {0, 0}, Colors({kRed, kRed})), (std::vector<int>{0, 0}));
  EXPECT_TRUE(MergeByColor(VoxelGrid{}, {}, cv::Mat()).empty());
}

}  // namespace
}  // namespace fovea::paper
