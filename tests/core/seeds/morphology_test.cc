#include "core/seeds/morphology.h"

#include <gtest/gtest.h>

#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <queue>
#include <random>
#include <vector>

namespace fovea {
namespace {

// Values 0 … levels - 1: few levels make plateaus, many make noise.
cv::Mat RandomMap(cv::Size size, unsigned levels, std::mt19937& random) {
  cv::Mat map(size, CV_32F);
  for (auto& value : cv::Mat_<float>(map)) value = static_cast<float>(random() % levels);
  return map;
}

// Plateaus larger than a pixel, in the shape of opened saliency maps.
cv::Mat RandomPlateaus(cv::Size size, std::mt19937& random) {
  return ErodeByDisk(RandomMap(size, 50, random), 2);
}

void ExpectEqual(const cv::Mat& actual, const cv::Mat& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  ASSERT_EQ(actual.type(), expected.type());
  EXPECT_EQ(cv::countNonZero(actual != expected), 0) << "actual:\n"
                                                     << actual << "\nexpected:\n"
                                                     << expected;
}

cv::Mat BruteForceErosion(const cv::Mat& map, int radius) {
  cv::Mat eroded = map.clone();
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.cols; ++x) {
      for (int other_y = 0; other_y < map.rows; ++other_y) {
        for (int other_x = 0; other_x < map.cols; ++other_x) {
          const cv::Point between(other_x - x, other_y - y);
          if (between.dot(between) > radius * radius) continue;
          eroded.at<float>(y, x) =
              std::min(eroded.at<float>(y, x), map.at<float>(other_y, other_x));
        }
      }
    }
  }
  return eroded;
}

// The maximum over the 3×3 pixels about a pixel, as far as they lie in the image.
float NeighbourhoodMaximum(const cv::Mat& map, cv::Point pixel) {
  const cv::Rect around(pixel.x - 1, pixel.y - 1, 3, 3);
  double most = 0;
  cv::minMaxLoc(map(around & cv::Rect({0, 0}, map.size())), nullptr, &most);
  return static_cast<float>(most);
}

cv::Mat BruteForceReconstruction(const cv::Mat& marker, const cv::Mat& mask) {
  cv::Mat map = cv::min(marker, mask);
  for (;;) {
    cv::Mat next = map.clone();
    for (int y = 0; y < map.rows; ++y) {
      for (int x = 0; x < map.cols; ++x) {
        next.at<float>(y, x) = std::min(NeighbourhoodMaximum(map, {x, y}), mask.at<float>(y, x));
      }
    }
    if (cv::countNonZero(next != map) == 0) return map;
    map = next;
  }
}

// A pixel is in a maximum if no ascent or level path leads from it to a higher value.
cv::Mat BruteForceMaxima(const cv::Mat& map) {
  cv::Mat labels = cv::Mat::zeros(map.size(), CV_32S);
  int count = 0;
  const cv::Rect image({0, 0}, map.size());
  for (int start_y = 0; start_y < map.rows; ++start_y) {
    for (int start_x = 0; start_x < map.cols; ++start_x) {
      if (labels.at<int>(start_y, start_x) != 0) continue;
      const float value = map.at<float>(start_y, start_x);
      cv::Mat plateau = cv::Mat::zeros(map.size(), CV_8U);
      std::queue<cv::Point> queue({{start_x, start_y}});
      plateau.at<std::uint8_t>(start_y, start_x) = 255;
      bool is_maximum = true;
      for (; !queue.empty(); queue.pop()) {
        for (int i = 0; i < 9; ++i) {
          const cv::Point other = queue.front() + cv::Point(i % 3 - 1, i / 3 - 1);
          if (!image.contains(other)) continue;
          is_maximum &= map.at<float>(other) <= value;
          if (map.at<float>(other) != value || plateau.at<std::uint8_t>(other) != 0) continue;
          plateau.at<std::uint8_t>(other) = 255;
          queue.push(other);
        }
      }
      if (is_maximum && cv::countNonZero(plateau == 0) > 0) labels.setTo(++count, plateau);
    }
  }
  return labels;
}

const std::vector<cv::Size> kSizes{{1, 1}, {1, 8}, {8, 1}, {2, 3}, {7, 7}, {16, 9}, {31, 22}};
// Rows are looked at in parts of 64 pixels.
const std::vector<cv::Size> kWideSizes{{64, 5}, {65, 1}, {65, 4}, {128, 3}, {140, 9}};

TEST(ErodeByDisk, IsTheMinimumOverTheDisk) {
  std::mt19937 random(20);
  for (const cv::Size& size : kSizes) {
    const cv::Mat map = RandomMap(size, 1000, random);
    for (int radius : {0, 1, 2, 3, 4, 5, 7, 10, 20, 50}) {
      SCOPED_TRACE(testing::Message() << size << " radius " << radius);
      ExpectEqual(ErodeByDisk(map, radius), BruteForceErosion(map, radius));
    }
  }
}

// The radius grows with the width: what lies above and below a ribbon would take gigabytes.
TEST(ErodeByDisk, TakesNoMoreThanARibbonNeeds) {
  std::mt19937 random(4);
  const cv::Mat ribbon = RandomMap({90, 2}, 50, random);
  const cv::Mat eroded = ErodeByDisk(ribbon, 40);
  ExpectEqual(eroded, BruteForceErosion(ribbon, 40));
  cv::Size whole;
  cv::Point at;
  eroded.locateROI(whole, at);
  EXPECT_LE(whole.height, 3 * ribbon.rows);
}

TEST(ErodeByDisk, CopiesAtRadiusZero) {
  std::mt19937 random(4);
  const cv::Mat map = RandomMap({12, 9}, 1000, random);
  cv::Mat eroded = ErodeByDisk(map, 0);
  ExpectEqual(eroded, map);
  EXPECT_NE(eroded.data, map.data);
}

TEST(ErodeByDisk, TakesNegativeValues) {
  cv::Mat map(5, 5, CV_32F, cv::Scalar(3));
  map.at<float>(2, 2) = -7;
  const cv::Mat expected = (cv::Mat_<float>(5, 5) << 3, 3, 3, 3, 3,  //
                            3, 3, -7, 3, 3,                          //
                            3, -7, -7, -7, 3,                        //
                            3, 3, -7, 3, 3,                          //
                            3, 3, 3, 3, 3);
  ExpectEqual(ErodeByDisk(map, 1), expected);
}

TEST(ReconstructByDilation, IsTheLimitOfDilationUnderTheMask) {
  std::vector<cv::Size> sizes = kSizes;
  sizes.insert(sizes.end(), kWideSizes.begin(), kWideSizes.end());
  std::mt19937 random(1993);
  for (int trial = 0; trial < 120; ++trial) {
    const cv::Size size = sizes[static_cast<std::size_t>(trial) % sizes.size()];
    SCOPED_TRACE(testing::Message() << "seed 1993, trial " << trial << ", " << size);
    const cv::Mat mask = RandomMap(size, trial % 2 == 0 ? 6 : 1000, random);
    const cv::Mat marker = cv::max(mask - RandomMap(size, trial % 3 == 0 ? 4 : 900, random), 0);
    ExpectEqual(ReconstructByDilation(marker, mask), BruteForceReconstruction(marker, mask));
  }
}

TEST(ReconstructByDilation, FollowsACorridorOfManyTurns) {
  for (const int cols : {20, 150}) {
    cv::Mat rows = cv::Mat::zeros(21, cols, CV_32F);
    for (int y = 0; y < rows.rows; y += 2) rows.row(y) = 1.0F;
    for (int y = 1; y < rows.rows; y += 2) rows.at<float>(y, y % 4 == 1 ? cols - 1 : 0) = 1.0F;
    for (const cv::Mat& mask : {rows, cv::Mat(rows.t())}) {
      const cv::Point last(mask.cols - 1, mask.rows - 1);
      for (const cv::Point& start : {cv::Point(0, 0), last, cv::Point(10, 10)}) {
        cv::Mat marker = cv::Mat::zeros(mask.size(), CV_32F);
        marker.at<float>(start) = 1.0F;
        ExpectEqual(ReconstructByDilation(marker, mask), mask);
      }
    }
  }
}

// Ways that turn again and again, across the parts of rows too.
TEST(ReconstructByDilation, FollowsWaysThroughNoise) {
  std::mt19937 random(407);
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE(testing::Message() << "seed 407, trial " << trial);
    cv::Mat mask(40, 200, CV_32F);
    for (auto& value : cv::Mat_<float>(mask)) value = random() % 100 < 42 ? 1.0F : 0.0F;
    const cv::Point start(static_cast<int>(random() % 200), static_cast<int>(random() % 40));
    mask.at<float>(start) = 1.0F;
    cv::Mat marker = cv::Mat::zeros(mask.size(), CV_32F);
    marker.at<float>(start) = 1.0F;
    cv::Mat filled = mask.clone();
    cv::floodFill(filled, start, 2, nullptr, 0, 0, 8);
    const cv::Mat expected = cv::max(filled - 1, 0);
    EXPECT_EQ(cv::countNonZero(ReconstructByDilation(marker, mask) != expected), 0);
  }
}

TEST(ReconstructByDilation, LowersAMarkerAboveTheMask) {
  const cv::Mat mask = (cv::Mat_<float>(1, 5) << 2, 1, 0, 4, 3);
  const cv::Mat marker(1, 5, CV_32F, cv::Scalar(9));
  ExpectEqual(ReconstructByDilation(marker, mask), mask);
}

TEST(LabelRegionalMaxima, FindsThePlateausWithoutHigherNeighbours) {
  std::mt19937 random(17);
  for (int trial = 0; trial < 80; ++trial) {
    const cv::Size size = kSizes[static_cast<std::size_t>(trial) % kSizes.size()];
    SCOPED_TRACE(testing::Message() << "seed 17, trial " << trial << ", " << size);
    const cv::Mat map = trial % 2 == 0 ? RandomPlateaus(size, random) : RandomMap(size, 5, random);
    ExpectEqual(LabelRegionalMaxima(map), BruteForceMaxima(map));
  }
}

TEST(LabelRegionalMaxima, NumbersInRowMajorOrder) {
  const cv::Mat map = (cv::Mat_<float>(4, 5) << 0, 0, 0, 0, 7,  //
                       5, 5, 0, 0, 0,                           //
                       0, 5, 0, 6, 0,                           //
                       0, 0, 0, 0, 6);
  const cv::Mat expected = (cv::Mat_<int>(4, 5) << 0, 0, 0, 0, 1,  //
                            2, 2, 0, 0, 0,                         //
                            0, 2, 0, 3, 0,                         //
                            0, 0, 0, 0, 3);
  ExpectEqual(LabelRegionalMaxima(map), expected);
}

TEST(LabelRegionalMaxima, FindsNoneInAConstantMap) {
  for (const cv::Size& size : kSizes) {
    const cv::Mat map(size, CV_32F, cv::Scalar(0.5));
    ExpectEqual(LabelRegionalMaxima(map), cv::Mat::zeros(size, CV_32S));
  }
}

}  // namespace
}  // namespace fovea
