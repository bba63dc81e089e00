#include "core/planning/height_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <random>

namespace fovea {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

// A camera 1 m above a floor that it looks straight down on: 101 x 81 pixels, 5 mm apart on the
// floor. Its upper border is away from it.
cv::Mat Floor() {
  cv::Mat points(81, 101, CV_32FC3);
  for (int row = 0; row < points.rows; ++row) {
    for (int column = 0; column < points.cols; ++column) {
      points.at<cv::Vec3f>(row, column) = {0.005F * static_cast<float>(column - 50),
                                           0.005F * static_cast<float>(row - 40), 1};
    }
  }
  return points;
}

const Eigen::Vector3f kUp = -Eigen::Vector3f::UnitZ();

// Height where a point of the camera frame is.
float HeightAt(const HeightMap& map, const Eigen::Vector3f& point) {
  const Eigen::Vector3f place = map.pose.inverse(Eigen::Isometry) * point / map.cell_m;
  return map.heights_m.at<float>(static_cast<int>(std::lround(place.y())),
                                 static_cast<int>(std::lround(place.x())));
}

TEST(HeightMap, HasTheHighestPointOfEachCell) {
  cv::Mat points = Floor();
  points.at<cv::Vec3f>(40, 50)[2] = 0.9F;
  points.at<cv::Vec3f>(40, 51)[2] = 0.8F;
  const HeightMap map = MakeHeightMap(points, kUp, 1, {.cell_m = 0.05F});
  EXPECT_EQ(map.heights_m.size(), cv::Size(11, 9));
  EXPECT_FLOAT_EQ(map.cell_m, 0.05F);
  EXPECT_NEAR(HeightAt(map, {0, 0, 1}), 0.2, 1e-6);
  EXPECT_NEAR(HeightAt(map, {0.1F, 0.1F, 1}), 0, 1e-6);
  // The first cell is the nearest to the left, at the lower border of the image.
  EXPECT_TRUE(map.pose.translation().isApprox(Eigen::Vector3f(-0.25F, 0.2F, 1), 1e-5F));
  EXPECT_TRUE(map.pose.linear().col(2).isApprox(kUp));
  EXPECT_NEAR(map.pose.linear().determinant(), 1, 1e-6);
}

// A post of one pixel at x = 0.03 m and 0.02 m below the middle of the image; cells are 0.05 m
// wide, around multiples of that.
TEST(HeightMap, AHeightIsInTheCellWhoseMiddleIsNearest) {
  cv::Mat points = Floor();
  points.at<cv::Vec3f>(44, 56)[2] = 0.9F;
  const HeightMap map = MakeHeightMap(points, kUp, 1, {.cell_m = 0.05F});
  EXPECT_NEAR(HeightAt(map, {0.05F, 0, 1}), 0.1, 1e-6);
  EXPECT_NEAR(HeightAt(map, {0, 0, 1}), 0, 1e-6);
  EXPECT_NEAR(HeightAt(map, {0.05F, 0.05F, 1}), 0, 1e-6);
}

// Wherever points lie between the middles of cells, which are 1 m wide here.
TEST(HeightMap, EachPointIsInACell) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> place_m(-20, 20);
  for (int i = 0; i < 200; ++i) {
    cv::Mat points(1, 3, CV_32FC3);
    for (int column = 0; column < 3; ++column) {
      points.at<cv::Vec3f>(column) = {place_m(random), place_m(random), -0.001F * place_m(random)};
    }
    const HeightMap map = MakeHeightMap(points, kUp, 0, {.cell_m = 1});
    for (int column = 0; column < 3; ++column) {
      const cv::Vec3f& p = points.at<cv::Vec3f>(column);
      const Eigen::Vector3f place = map.pose.inverse(Eigen::Isometry) * Eigen::Vector3f(p.val);
      const cv::Point cell(cvRound(place.x()), cvRound(place.y()));
      ASSERT_TRUE(cv::Rect({}, map.heights_m.size()).contains(cell)) << i << ": " << place;
      EXPECT_GE(map.heights_m.at<float>(cell), place.z() - 1e-6F) << i;
    }
  }
}

// A table 0.2 m above the floor: heights are from its top on.
TEST(HeightMap, IsAboveThePlane) {
  const HeightMap map = MakeHeightMap(Floor(), kUp, 0.8F, {.cell_m = 0.05F});
  EXPECT_NEAR(map.heights_m.at<float>(0, 0), -0.2, 1e-6);
  EXPECT_NEAR(map.pose.translation().z(), 0.8, 1e-6);
}

TEST(HeightMap, WhatWasNotSeenIsUnknown) {
  cv::Mat points = Floor();
  points(cv::Rect(30, 20, 30, 30)).setTo(cv::Scalar::all(kNone));
  const HeightMap map = MakeHeightMap(points, kUp, 1, {.cell_m = 0.02F});
  EXPECT_TRUE(std::isnan(HeightAt(map, {-0.03F, -0.03F, 1})));
  EXPECT_FALSE(std::isnan(HeightAt(map, {0.1F, -0.03F, 1})));
}

TEST(HeightMap, SurfaceBetweenPixelsIsSeenWhereTheDepthGoesOn) {
  // 5 mm between pixels, cells of 1 mm: known along rows and columns of pixels.
  cv::Mat points = Floor();
  cv::Mat right = points(cv::Rect(50, 0, 51, 81));
  cv::subtract(right, cv::Scalar(0, 0, 0.3), right);
  const HeightMap map = MakeHeightMap(points, kUp, 1, {.cell_m = 0.001F, .max_cells = 1000000});
  EXPECT_NEAR(HeightAt(map, {-0.102F, 0, 1}), 0, 1e-5);
  EXPECT_NEAR(HeightAt(map, {0.102F, 0, 1}), 0.3, 1e-5);
  EXPECT_NEAR(HeightAt(map, {-0.1F, 0.002F, 1}), 0, 1e-5);
  EXPECT_TRUE(std::isnan(HeightAt(map, {-0.002F, 0, 1})));  // across the step
}

TEST(HeightMap, IsBoundedInSizeAndKeepsWhatIsNear) {
  // From a camera 1 m above a level floor: 0.5 to 10 m away, 2 m to each side.
  cv::Mat points(96, 41, CV_32FC3);
  for (int row = 0; row < points.rows; ++row) {
    for (int column = 0; column < points.cols; ++column) {
      points.at<cv::Vec3f>(row, column) = {0.1F * static_cast<float>(column - 20), 1,
                                           0.5F + 0.1F * static_cast<float>(row)};
    }
  }
  const Eigen::Vector3f up = -Eigen::Vector3f::UnitY();
  const HeightMap whole = MakeHeightMap(points, up, 1, {.cell_m = 0.1F, .max_cells = 10000});
  EXPECT_EQ(whole.heights_m.size(), cv::Size(41, 96));
  const HeightMap part = MakeHeightMap(points, up, 1, {.cell_m = 0.1F, .max_cells = 400});
  EXPECT_EQ(part.heights_m.size(), cv::Size(20, 20));
  EXPECT_NEAR(part.pose.translation().x(), -1, 1e-5);
  EXPECT_NEAR(part.pose.translation().z(), 0.5, 1e-5);
  EXPECT_NEAR(HeightAt(part, {0, 1, 0.5F}), 0, 1e-6);
}

TEST(HeightMap, IsAroundACameraThatLooksStraightDownWhereItIsBounded) {
  for (const float cell_m : {0.01F, 0.002F}) {  // of the smaller ones one side alone has too many
    const HeightMap part = MakeHeightMap(Floor(), kUp, 1, {.cell_m = cell_m, .max_cells = 100});
    EXPECT_EQ(part.heights_m.size(), cv::Size(10, 10));
    const Eigen::Vector3f corner = part.pose.translation() / cell_m;
    EXPECT_NEAR(std::abs(corner.x()), 5, 0.01) << cell_m;
    EXPECT_NEAR(std::abs(corner.y()), 5, 0.01) << cell_m;
  }
}

// The cells that a strip does not need across go to its length.
TEST(HeightMap, OfAStripIsLongWhereItIsBounded) {
  const cv::Mat across = Floor().rowRange(0, 4), along = Floor().colRange(0, 4);
  const auto size_of = [](const cv::Mat& points, int max_cells) {
    return MakeHeightMap(points, kUp, 1, {.cell_m = 0.005F, .max_cells = max_cells})
        .heights_m.size();
  };
  EXPECT_EQ(size_of(across, 200), cv::Size(50, 4));
  EXPECT_EQ(size_of(along, 200), cv::Size(4, 50));
  EXPECT_EQ(size_of(Floor().rowRange(0, 20), 399), cv::Size(19, 20))
      << "not 21 rows, of which 20 are seen";
}

// 10 of 40 columns, all to the left of the camera: those that are nearest to it.
TEST(HeightMap, OfWhatIsBesideTheCameraIsTheNearestPart) {
  const cv::Mat left = Floor()(cv::Rect(0, 36, 40, 10));
  const HeightMap part = MakeHeightMap(left, kUp, 1, {.cell_m = 0.005F, .max_cells = 100});
  EXPECT_EQ(part.heights_m.size(), cv::Size(10, 10));
  EXPECT_NEAR(part.pose.translation().x(), -0.1, 1e-6);
  EXPECT_NEAR(HeightAt(part, {-0.055F, 0, 1}), 0, 1e-6);
}

TEST(HeightMap, OfNothingIsOneUnknownCell) {
  const cv::Mat points(4, 4, CV_32FC3, cv::Scalar::all(kNone));
  const HeightMap map = MakeHeightMap(points, kUp, 1, {});
  ASSERT_EQ(map.heights_m.size(), cv::Size(1, 1));
  EXPECT_TRUE(std::isnan(map.heights_m.at<float>(0, 0)));
}

}  // namespace
}  // namespace fovea
