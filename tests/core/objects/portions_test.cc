#include "core/objects/portions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/core.hpp>

namespace fovea {
namespace {

// A row of voxels, one a pixel, of which neighbours in `parts` with the same number touch.
VoxelGrid RowOfParts(const std::vector<int>& parts) {
  VoxelGrid grid;
  const int count = static_cast<int>(parts.size());
  grid.voxels.resize(parts.size());
  grid.voxel_of_pixel = cv::Mat(1, count, CV_32SC1);
  for (int v = 0; v < count; ++v) {
    grid.voxel_of_pixel.at<int>(0, v) = v;
    if (v > 0 && parts[v] == parts[v - 1]) grid.edges.push_back({v - 1, v});
  }
  return grid;
}

const std::vector<int> kParts{1, 1, 0, 2, 2, 0, 3, 3, 0, 4, 4};
const std::vector<char> kBackground{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0};

std::vector<int> Inside(const std::vector<char>& outside) {
  std::vector<int> inside;
  for (int v = 0; v < static_cast<int>(outside.size()); ++v) {
    if (outside[v] == 0) inside.push_back(v);
  }
  return inside;
}

TEST(SalientPortions, ComeByFallingSaliencyInWholeParts) {
  const cv::Mat saliency =
      (cv::Mat_<float>(1, 11) << 0.1, 0.3, 1, 0.9, 0.7, 1, 0.5, 0.6, 1, 0.4, 0.0);
  const auto portions = SalientPortions(RowOfParts(kParts), kBackground, saliency, 2);
  ASSERT_EQ(portions.size(), 2U);
  EXPECT_EQ(Inside(portions[0]), (std::vector<int>{3, 4, 6, 7}));
  EXPECT_EQ(Inside(portions[1]), (std::vector<int>{0, 1, 9, 10}));
}

TEST(SalientPortions, AreFewerThanAskedForWhereAPartIsLarge) {
  const std::vector<int> one(11, 1);
  const auto portions = SalientPortions(RowOfParts(one), std::vector<char>(11, 0),
                                        cv::Mat(1, 11, CV_32F, cv::Scalar(1.0)), 4);
  ASSERT_EQ(portions.size(), 1U);
  EXPECT_EQ(Inside(portions[0]).size(), 11U);
}

TEST(SalientPortions, OfNothingAreOneOfNothing) {
  const auto portions = SalientPortions(RowOfParts(kParts), std::vector<char>(11, 1),
                                        cv::Mat(1, 11, CV_32F, cv::Scalar(1.0)), 4);
  ASSERT_EQ(portions.size(), 1U);
  EXPECT_TRUE(Inside(portions[0]).empty());
}

}  // namespace
}  // namespace fovea
