#include "core/segmentation/image_borders.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace fovea {
namespace {

cv::Mat Labels(const std::vector<std::uint16_t>& labels, int rows) {
  return cv::Mat(labels, true).reshape(1, rows);
}

// Points that have nothing but depth.
cv::Mat Depths(const std::vector<float>& depths, int rows) {
  std::vector<cv::Vec3f> points;
  points.reserve(depths.size());
  for (const float z : depths) points.emplace_back(0, 0, z);
  return cv::Mat(points, true).reshape(3, rows);
}

using Pair = std::pair<int, int>;

TEST(FindImageBorders, CountsMeetingPixelsAlongRowsAndColumns) {
  const cv::Mat labels = Labels({1, 1, 2,  //
                                 1, 2, 2,  //
                                 3, 3, 3},
                                3);
  const auto borders = FindImageBorders(labels, Depths(std::vector<float>(9, 1), 3), 1, 0.01F);
  ASSERT_EQ(borders.size(), 3U);
  EXPECT_EQ(borders.at(Pair(1, 2)).length_px, 3);  // two along rows, one along a column
  EXPECT_EQ(borders.at(Pair(1, 3)).length_px, 1);
  EXPECT_EQ(borders.at(Pair(2, 3)).length_px, 2);
  for (const auto& [pair, border] : borders) {
    EXPECT_EQ(border.first_in_front + border.second_in_front, 0);
  }
}

TEST(FindImageBorders, TellsWhichIsInFront) {
  const cv::Mat depths = Depths({1.0F, 1.5F,  //
                                 1.0F, 0.8F,  //
                                 1.0F, 1.005F},
                                3);
  const ImageBorder ascending =
      FindImageBorders(Labels({1, 2, 1, 2, 1, 2}, 3), depths, 1, 0.01F).at(Pair(1, 2));
  EXPECT_EQ(ascending.length_px, 3);
  EXPECT_EQ(ascending.first_in_front, 1);
  EXPECT_EQ(ascending.second_in_front, 1);
  const cv::Mat nearer = Depths({1.0F, 1.5F, 1.0F, 1.4F, 1.0F, 1.3F}, 3);
  const ImageBorder descending =
      FindImageBorders(Labels({7, 4, 7, 4, 7, 4}, 3), nearer, 1, 0.01F).at(Pair(4, 7));
  EXPECT_EQ(descending.first_in_front, 0);
  EXPECT_EQ(descending.second_in_front, 3);
}

TEST(FindImageBorders, TheStepIsAShareOfTheDepth) {
  const cv::Mat labels = Labels({1, 2}, 1);
  const auto in_front = [&](float a, float b) {
    return FindImageBorders(labels, Depths({a, b}, 1), 1, 0.02F).at(Pair(1, 2)).first_in_front;
  };
  EXPECT_EQ(in_front(1.0F, 1.03F), 1);
  EXPECT_EQ(in_front(2.0F, 2.03F), 0);  // the step is 4 cm there
  EXPECT_EQ(in_front(2.0F, 2.05F), 1);
}

TEST(FindImageBorders, BridgesGapsUpToTheReach) {
  const cv::Mat row = Labels({1, 1, 0, 0, 2, 2}, 1);
  const cv::Mat depths = Depths({1, 1, 9, 9, 2, 2}, 1);
  EXPECT_TRUE(FindImageBorders(row, depths, 1, 0.01F).empty());
  EXPECT_TRUE(FindImageBorders(row, depths, 2, 0.01F).empty());
  EXPECT_EQ(FindImageBorders(row, depths, 3, 0.01F).at(Pair(1, 2)).length_px, 1);
  EXPECT_EQ(FindImageBorders(row, depths, 4, 0.01F).at(Pair(1, 2)).first_in_front, 2);
  const cv::Mat column = row.reshape(1, 6);
  EXPECT_EQ(FindImageBorders(column, depths.reshape(3, 6), 4, 0.01F).at(Pair(1, 2)).length_px, 2);
}

TEST(FindImageBorders, NoneIsInFrontWithoutDepth) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const cv::Mat labels = Labels({1, 2, 1}, 1);
  const ImageBorder border =
      FindImageBorders(labels, Depths({1, nan, 2}, 1), 1, 0.01F).at(Pair(1, 2));
  EXPECT_EQ(border.length_px, 2);
  EXPECT_EQ(border.first_in_front + border.second_in_front, 0);
}

TEST(FindImageBorders, BackgroundHasNone) {
  EXPECT_TRUE(FindImageBorders(Labels({0, 1, 0, 0}, 2), Depths({1, 2, 3, 4}, 2), 1, 0).empty());
}

}  // namespace
}  // namespace fovea
