#include "core/depth/registration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <opencv2/core.hpp>
#include <random>
#include <stdexcept>

#include "core/types/cancelled.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
const CameraIntrinsics kDepthCamera{.fx_px = 100, .fy_px = 90, .cx_px = 20, .cy_px = 15};
const cv::Size kSize{40, 30};

Eigen::Isometry3d Shift(double x, double y, double z) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

CameraIntrinsics Finer(const CameraIntrinsics& camera, double times) {
  return {camera.fx_px * times, camera.fy_px * times, camera.cx_px * times + (times - 1) / 2,
          camera.cy_px * times + (times - 1) / 2};
}

int CountMeasured(const cv::Mat& depth) { return cv::countNonZero(depth == depth); }

// Smooth ground, a nearer box, and every fourth pixel without depth.
cv::Mat Relief() {
  cv::Mat depth(kSize, CV_32FC1);
  std::mt19937 random(1);
  for (int y = 0; y < depth.rows; ++y) {
    for (int x = 0; x < depth.cols; ++x) {
      const bool on_box = x > 10 && x < 25 && y > 8 && y < 20;
      depth.at<float>(y, x) = (on_box ? 0.8F : 1.5F + 0.01F * y) + 1e-5F * float(random() % 1000);
      if (random() % 4 == 0) depth.at<float>(y, x) = kNan;
    }
  }
  return depth;
}

TEST(RegisterDepth, LeavesDepthOfTheSameCameraAsItIs) {
  const cv::Mat depth = Relief();
  const cv::Mat same = RegisterDepth(depth, kDepthCamera, Shift(0, 0, 0), kDepthCamera, kSize);
  for (int y = 0; y < depth.rows; ++y) {
    for (int x = 0; x < depth.cols; ++x) {
      const float z = depth.at<float>(y, x);
      if (std::isnan(z)) {
        EXPECT_TRUE(std::isnan(same.at<float>(y, x))) << x << ", " << y;
      } else {
        // The slack of a triangle may take a thousandth of a pixel from a nearer neighbour.
        EXPECT_NEAR(same.at<float>(y, x), z, 1e-6) << x << ", " << y;
      }
    }
  }
}

TEST(RegisterDepth, TakesEveryBadDepthForNone) {
  cv::Mat depth(kSize, CV_32FC1, cv::Scalar(kNan));
  depth.row(1) = 0;
  depth.row(2) = -1;
  depth.row(3) = std::numeric_limits<float>::infinity();
  depth.row(4) = -std::numeric_limits<float>::infinity();
  EXPECT_EQ(CountMeasured(RegisterDepth(depth, kDepthCamera, Shift(0, 0, 0), kDepthCamera, kSize)),
            0);
}

TEST(RegisterDepth, ShiftsByTheParallax) {
  cv::Mat depth(kSize, CV_32FC1, cv::Scalar(kNan));
  depth.at<float>(12, 8) = 1.25F;
  // 0.05 m · 100 px / 1.25 m = 4 px right, and 9 px of 0.125 m down.
  const cv::Mat shifted =
      RegisterDepth(depth, kDepthCamera, Shift(0.05, 0.125, 0), kDepthCamera, kSize);
  EXPECT_EQ(CountMeasured(shifted), 1);
  EXPECT_FLOAT_EQ(shifted.at<float>(12 + 9, 8 + 4), 1.25F);
}

TEST(RegisterDepth, MeasuresDepthAlongTheColorCamera) {
  const cv::Mat depth(kSize, CV_32FC1, cv::Scalar(1.25F));
  const cv::Mat moved = RegisterDepth(depth, kDepthCamera, Shift(0, 0, -0.25), kDepthCamera, kSize);
  EXPECT_EQ(CountMeasured(moved), kSize.area());  // nearer, so that the image overflows
  EXPECT_FLOAT_EQ(moved.at<float>(3, 3), 1);
}

TEST(RegisterDepth, FollowsAPlaneSeenByATurnedCamera) {
  // The plane z = 1.5 of the depth camera; colour looks 10° past it.
  const double angle = 10 * std::numbers::pi / 180;
  Eigen::Isometry3d color_from_depth = Shift(0.03, -0.02, 0.01);
  color_from_depth.rotate(Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 0).normalized()));
  const CameraIntrinsics color = Finer(kDepthCamera, 2.6);
  const cv::Size size(104, 78);
  const cv::Mat depth(kSize, CV_32FC1, cv::Scalar(1.5F));
  const cv::Mat seen = RegisterDepth(depth, kDepthCamera, color_from_depth, color, size);
  EXPECT_GT(CountMeasured(seen), size.area() / 3);

  const Eigen::Vector3d normal = color_from_depth.linear().col(2);
  const double offset = normal.dot(color_from_depth * Eigen::Vector3d(0, 0, 1.5));
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const float z = seen.at<float>(y, x);
      if (std::isnan(z)) continue;
      const Eigen::Vector3d ray((x - color.cx_px) / color.fx_px, (y - color.cy_px) / color.fy_px,
                                1);
      // At the image's border the depth of the last pixel goes on for half a pixel.
      EXPECT_NEAR(z, offset / normal.dot(ray), 2e-3) << x << ", " << y;
    }
  }
}

TEST(RegisterDepth, HasNoHolesWhereColorIsFiner) {
  cv::Mat depth(kSize, CV_32FC1);
  for (int y = 0; y < depth.rows; ++y) {
    for (int x = 0; x < depth.cols; ++x) {
      depth.at<float>(y, x) = 1 + 0.012F * float(y) + 0.03F * std::sin(0.3F * float(x));
    }
  }
  for (const double times : {2.0, 3.0, 3.3, 7.0}) {
    const cv::Size size(cvRound(kSize.width * times), cvRound(kSize.height * times));
    const cv::Mat fine =
        RegisterDepth(depth, kDepthCamera, Shift(0.02, 0.01, 0), Finer(kDepthCamera, times), size);
    // The parallax leaves a margin on the sides that colour sees alone; none opens inside.
    const cv::Rect inside = {int(5 * times), int(5 * times), int(30 * times), int(20 * times)};
    EXPECT_EQ(CountMeasured(fine(inside)), inside.area()) << times;
  }
}

TEST(RegisterDepth, KeepsASinglePixelsFootprint) {
  cv::Mat depth(kSize, CV_32FC1, cv::Scalar(kNan));
  depth.at<float>(12, 8) = 1;
  const cv::Mat fine =
      RegisterDepth(depth, kDepthCamera, Shift(0, 0, 0), Finer(kDepthCamera, 3), kSize * 3);
  EXPECT_EQ(CountMeasured(fine), 9);
  EXPECT_EQ(CountMeasured(fine({8 * 3, 12 * 3, 3, 3})), 9);
}

TEST(RegisterDepth, ShowsTheNearest) {
  cv::Mat depth(kSize, CV_32FC1, cv::Scalar(2.0F));
  depth({10, 10, 10, 10}) = 0.5F;
  // Near moves by 8 px, far by 2.
  const cv::Mat seen = RegisterDepth(depth, kDepthCamera, Shift(0.04, 0, 0), kDepthCamera, kSize);
  EXPECT_EQ(cv::countNonZero(seen == 0.5F), 100);
  EXPECT_EQ(cv::countNonZero(seen({18, 10, 10, 10}) == 0.5F), 100);
}

TEST(RegisterDepth, LeavesWhatIsHiddenFromTheDepthCameraEmpty) {
  cv::Mat depth(kSize, CV_32FC1, cv::Scalar(2.0F));
  depth({10, 10, 10, 10}) = 0.5F;
  const cv::Mat seen = RegisterDepth(depth, kDepthCamera, Shift(0.04, 0, 0), kDepthCamera, kSize);
  // Nothing else than the two surfaces, and between them the shadow of 8 − 2 px.
  EXPECT_EQ(cv::countNonZero((seen == 0.5F) | (seen == 2.0F)), CountMeasured(seen));
  EXPECT_EQ(CountMeasured(seen({12, 10, 6, 10})), 0);
  EXPECT_EQ(CountMeasured(seen), kSize.area() - 2 * kSize.height - 60);
}

TEST(RegisterDepth, DrawsNoSkinAcrossEdgesOfFinerColor) {
  cv::Mat depth(kSize, CV_32FC1, cv::Scalar(1.5F));
  depth({10, 10, 10, 10}) = 1.3F;
  const cv::Mat fine =
      RegisterDepth(depth, kDepthCamera, Shift(0.03, -0.01, 0), Finer(kDepthCamera, 4), kSize * 4);
  EXPECT_EQ(cv::countNonZero((fine > 1.301F) & (fine < 1.499F)), 0);
}

TEST(RegisterDepth, DropsWhatIsBehindTheColorCamera) {
  const cv::Mat depth(kSize, CV_32FC1, cv::Scalar(1.0F));
  EXPECT_EQ(CountMeasured(RegisterDepth(depth, kDepthCamera, Shift(0, 0, -2), kDepthCamera, kSize)),
            0);
  EXPECT_EQ(
      CountMeasured(RegisterDepth(depth, kDepthCamera, Shift(0, 0, -0.995), kDepthCamera, kSize)),
      0);
}

// Depths of all magnitudes beside one another, cameras in odd places: an answer of positive depths
// or an error, soon.
TEST(RegisterDepth, SurvivesAnyNumbers) {
  std::mt19937 random(7);
  const auto number = [&] {
    const double magnitude = std::pow(10, std::uniform_real_distribution(-40.0, 39.0)(random));
    return random() % 2 == 0 ? magnitude : -magnitude;
  };
  for (int i = 0; i < 300; ++i) {
    cv::Mat depth(kSize, CV_32FC1);
    for (int y = 0; y < depth.rows; ++y) {
      for (int x = 0; x < depth.cols; ++x) {
        depth.at<float>(y, x) = i % 2 == 0 ? static_cast<float>(number()) : 1 + 1e-3F * float(x);
      }
    }
    const bool odd_camera = i % 3 == 0;
    const auto focal = [&] { return odd_camera ? std::abs(number()) : 100.0; };
    const CameraIntrinsics a{focal(), focal(), odd_camera ? number() : 20, 15};
    const CameraIntrinsics b{focal(), focal(), 20, odd_camera ? number() : 15};
    Eigen::Isometry3d color_from_depth = Shift(number(), number(), number());
    if (i % 5 == 0) color_from_depth = Shift(0, 0, -1.0);
    color_from_depth.rotate(Eigen::Quaterniond::UnitRandom());
    try {
      const cv::Mat seen = RegisterDepth(depth, a, color_from_depth, b, {64, 48});
      EXPECT_EQ(CountMeasured(seen), cv::countNonZero(seen > 0));
    } catch (const std::invalid_argument&) {
    }
  }
}

TEST(RegisterDepth, RefusesToDrawWithoutEnd) {
  // Checkered far depths just before the colour camera, which each fill a good part of its image.
  cv::Mat depth(200, 200, CV_32FC1);
  std::mt19937 random(3);
  for (auto z = depth.begin<float>(); z != depth.end<float>(); ++z) {
    *z = 100 + 0.001F * float(random() % 1000);
  }
  const CameraIntrinsics narrow{.fx_px = 1e4, .fy_px = 1e4, .cx_px = 100, .cy_px = 100};
  const CameraIntrinsics tele{.fx_px = 1e5, .fy_px = 1e5, .cx_px = 320, .cy_px = 240};
  Eigen::Isometry3d beside = Eigen::Isometry3d::Identity();
  beside.rotate(Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitY()));
  beside.pretranslate(Eigen::Vector3d(-100.5, 0, 2));
  EXPECT_THROW(RegisterDepth(depth, narrow, beside, tele, {640, 480}), std::invalid_argument);
}

TEST(RegisterDepth, RefusesEmptyImages) {
  EXPECT_THROW(RegisterDepth({}, kDepthCamera, Shift(0, 0, 0), kDepthCamera, kSize),
               std::invalid_argument);
  EXPECT_THROW(RegisterDepth(Relief(), kDepthCamera, Shift(0, 0, 0), kDepthCamera, {}),
               std::invalid_argument);
}

TEST(RegisterDepth, CanBeStopped) {
  const InterruptionScope scope([] { return true; }, std::chrono::microseconds(0));
  EXPECT_THROW(RegisterDepth(Relief(), kDepthCamera, Shift(0, 0, 0), kDepthCamera, kSize),
               Cancelled);
}

}  // namespace
}  // namespace fovea
