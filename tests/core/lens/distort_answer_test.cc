#include "core/lens/distort_answer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/core/lens/small_lenses.h"

namespace fovea {
namespace {

using testing::Barrel;
using testing::Cushion;
using testing::kSize;

// The tight rectangle of what is not 0.
cv::Rect BoundsOf(const cv::Mat& mask) { return cv::boundingRect(mask); }

// An object of a disk of the ideal image, with a point for each pixel that says which one.
Detections AnswerWithDisk(const cv::Point& middle, int radius_px) {
  Detections answer;
  answer.labels = cv::Mat::zeros(kSize, CV_16UC1);
  cv::circle(answer.labels, middle, radius_px, 1, cv::FILLED);
  DetectedObject& object = answer.objects.emplace_back();
  object.label = 1;
  object.bounds_px = BoundsOf(answer.labels == 1);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      if (answer.labels.at<std::uint16_t>(y, x) == 0) continue;
      object.cloud.push_back({static_cast<float>(x), static_cast<float>(y), 1, 0, 0, 0});
    }
  }
  object.num_pixels = object.cloud.size();
  return answer;
}

TEST(DistortAnswer, TakesAMaskToWhereTheCameraShowsIt) {
  const Lens lens = Barrel();
  const cv::Point middle(140, 100);
  Detections answer = AnswerWithDisk(middle, 12);
  Trace trace;
  DistortAnswer(lens, answer, trace);

  const DetectedObject& object = answer.objects.front();
  EXPECT_EQ(BoundsOf(answer.labels == 1), object.bounds_px);
  EXPECT_EQ(static_cast<std::size_t>(cv::countNonZero(answer.labels)), object.num_pixels);
  EXPECT_EQ(object.cloud.size(), object.num_pixels);
  for (int y = 0, next = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const cv::Point2d ideal = lens.Undistort(cv::Point2d(x, y));
      const double off = cv::norm(ideal - cv::Point2d(middle));
      const bool has_label = answer.labels.at<std::uint16_t>(y, x) == 1;
      if (off < 11 || off > 14) {
        EXPECT_EQ(has_label, off < 11) << x << ' ' << y;
      }
      if (!has_label) continue;
      const ColoredPoint& point = object.cloud[next++];
      EXPECT_NEAR(point.x, ideal.x, 0.51);
      EXPECT_NEAR(point.y, ideal.y, 0.51);
    }
  }
  // The disk would reach to column 152.
  EXPECT_LT(object.bounds_px.br().x, 150);
}

// Small squares side by side, and each pixel's point says which one it is.
Detections AnswerWithSquares(const cv::Size& size, int side_px) {
  Detections answer;
  answer.labels = cv::Mat::zeros(size, CV_16UC1);
  for (int y = 0; y + side_px <= size.height; y += side_px) {
    for (int x = 0; x + side_px <= size.width; x += side_px) {
      DetectedObject& object = answer.objects.emplace_back();
      object.label = static_cast<int>(answer.objects.size());
      object.bounds_px = {x, y, side_px, side_px};
      object.num_pixels = object.bounds_px.area();
      answer.labels(object.bounds_px) = object.label;
      for (int i = 0; i < object.bounds_px.area(); ++i) {
        object.cloud.push_back(
            {static_cast<float>(x + i % side_px), static_cast<float>(y + i / side_px), 1, 0, 0, 0});
      }
    }
  }
  return answer;
}

// Sent pixels between two ideal ones are those of one of the two squares, in all that is said.
TEST(DistortAnswer, MasksNumbersAndCloudsAgreeWhereObjectsTouch) {
  const cv::Size size(640, 480);
  for (const LensDistortion& distortion :
       {LensDistortion{LensDistortion::Model::kBrownConrady, {-0.15, 0.01, 0.001, 0.002}},
        LensDistortion{LensDistortion::Model::kBrownConrady, {0.3}},
        // Slight ones, where neighbours bend alike to the precision of Undistort.
        LensDistortion{LensDistortion::Model::kBrownConrady, {0.02, -0.01, 0.001, 0.001}},
        LensDistortion{LensDistortion::Model::kBrownConrady, {-0.004}},
        LensDistortion{LensDistortion::Model::kKannalaBrandt, {0.1}}}) {
    const Lens lens({520, 520, 319.5, 239.5}, distortion, size);
    Detections answer = AnswerWithSquares(size, 16);
    Trace trace;
    DistortAnswer(lens, answer, trace);
    for (const DetectedObject& object : answer.objects) {
      const cv::Mat mask = answer.labels == object.label;
      ASSERT_EQ(static_cast<std::size_t>(cv::countNonZero(mask)), object.num_pixels);
      ASSERT_EQ(object.cloud.size(), object.num_pixels);
      if (object.num_pixels == 0) continue;
      EXPECT_EQ(object.bounds_px, BoundsOf(mask));
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      for (const ColoredPoint& p : object.cloud) sum += Eigen::Vector3f(p.x, p.y, p.z);
      EXPECT_LT((sum / static_cast<float>(object.num_pixels) - object.centroid).norm(), 1e-3);
    }
  }
}

// An object alone, so that no rectangle beside it lets its pixels in; and one at the lower border.
// The last lens shows what is at its right border four times as large as what is in the middle.
TEST(DistortAnswer, APixelHasTheLabelOfTheIdealOneNearestToIt) {
  const Lens magnifier({130, 130, 79.5, 59.5},
                       {LensDistortion::Model::kBrownConrady, {0, 0, 0, 0, 0, -3}}, kSize);
  for (const Lens& lens : {Barrel(), Cushion(), magnifier}) {
    for (const cv::Rect& ideal : {cv::Rect(100, 70, 20, 20), cv::Rect(0, 90, 160, 30)}) {
      Detections answer;
      answer.labels = cv::Mat::zeros(kSize, CV_16UC1);
      answer.labels(ideal) = 1;
      answer.objects.resize(1);
      answer.objects[0].label = 1;
      answer.objects[0].bounds_px = ideal;
      Trace trace;
      DistortAnswer(lens, answer, trace);
      for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
          const cv::Point2d place = lens.Undistort(cv::Point2d(x, y));
          const cv::Point nearest = place;  // rounds
          const cv::Point2d off = place - cv::Point2d(nearest);
          // Undistort is good to a hundredth.
          if (std::max(std::abs(off.x), std::abs(off.y)) > 0.48) continue;
          ASSERT_EQ(answer.labels.at<std::uint16_t>(y, x), ideal.contains(nearest)) << nearest;
        }
      }
      EXPECT_TRUE(answer.objects[0].cloud.empty()) << "as it was";
    }
  }
}

// A barrel's corner shows fewer pixels of what is far out: of two halves that were as large, the
// inner one has more.
TEST(DistortAnswer, ColorsAreThoseOfThePixelsThatAreShown) {
  Detections answer = AnswerWithSquares(kSize, 120);
  DetectedObject& object = answer.objects.front();
  for (ColoredPoint& point : object.cloud) (point.x < 20 ? point.r : point.g) = 200;
  Trace trace;
  const Lens lens({60, 60, 79.5, 59.5}, {LensDistortion::Model::kBrownConrady, {-0.1}}, kSize);
  DistortAnswer(lens, answer, trace);
  const auto red = std::count_if(object.cloud.begin(), object.cloud.end(),
                                 [](const ColoredPoint& point) { return point.r > 0; });
  const float share = static_cast<float>(red) / static_cast<float>(object.num_pixels);
  ASSERT_EQ(object.colors.size(), 1U);
  EXPECT_EQ(object.colors.front().name, ColorName::kGreen);
  EXPECT_NEAR(object.colors.front().share, 1 - share, 1e-5);
  EXPECT_EQ(object.mean_color[0], std::lround(200 * share));
}

TEST(DistortAnswer, KeepsARectangleOfWhatTheCameraDoesNotShow) {
  // A cushion shows less of the ideal image.
  const Lens lens = Cushion();
  Detections answer = AnswerWithDisk({157, 117}, 2);
  answer.objects.front().centroid = {1, 2, 3};
  Trace trace;
  DistortAnswer(lens, answer, trace);
  EXPECT_EQ(answer.objects.front().num_pixels, 0U);
  EXPECT_EQ(answer.objects.front().bounds_px, cv::Rect(159, 119, 1, 1));
  EXPECT_EQ(answer.objects.front().centroid, Eigen::Vector3f(1, 2, 3));
}

// A barrel bends their sides outwards: farther out than their corners.
TEST(DistortAnswer, RectanglesHoldAllThatTheyHeld) {
  const Lens lens = Barrel();
  for (const cv::Rect& ideal : {cv::Rect(100, 15, 50, 90), cv::Rect(10, 15, 50, 90),
                                cv::Rect(20, 65, 120, 45), cv::Rect(20, 10, 120, 45)}) {
    Detections answer;
    answer.labels = cv::Mat::zeros(kSize, CV_16UC1);
    answer.rejected.push_back({ideal, 0.1F, "small"});
    Trace trace;
    DistortAnswer(lens, answer, trace);
    std::vector<cv::Point> held;
    for (int y = ideal.y; y < ideal.br().y; ++y) {
      for (int x = ideal.x; x < ideal.br().x; ++x)
        held.emplace_back(lens.Distort({1.0 * x, 1.0 * y}));
    }
    EXPECT_EQ(answer.rejected[0].bounds_px, cv::boundingRect(held)) << ideal;
  }
}

TEST(DistortAnswer, TakesSeedsRejectedAndImagesAlong) {
  const Lens lens = Barrel();
  Detections answer;
  answer.labels = cv::Mat::zeros(kSize, CV_16UC1);
  answer.rejected.push_back({cv::Rect(130, 90, 20, 20), 0.1F, "small"});
  Trace trace;
  trace.seeds.resize(1);
  trace.seeds[0].pixel = {150, 110};
  trace.removed.resize(1);
  trace.removed[0].pixel = {150, 110};
  trace.depth_m = cv::Mat(kSize, CV_32FC1, cv::Scalar(2));
  trace.depth_m.at<float>(110, 150) = 1;
  trace.voxels.voxel_of_pixel = cv::Mat(kSize, CV_32SC1, cv::Scalar(7));
  trace.depth_saliency = cv::Mat(kSize, CV_32FC1, cv::Scalar(0.5F));
  DistortAnswer(lens, answer, trace);

  const cv::Point expected = lens.Distort({150, 110});
  EXPECT_EQ(trace.seeds[0].pixel, expected);
  EXPECT_EQ(trace.removed[0].pixel, expected);
  EXPECT_EQ(trace.depth_m.at<float>(expected), 1);
  EXPECT_LE(cv::norm(answer.rejected[0].bounds_px.tl() - cv::Point(lens.Distort({130, 90}))), 1.5);
  EXPECT_EQ(trace.voxels.voxel_of_pixel.at<int>(60, 80), 7);
  EXPECT_EQ(trace.depth_saliency.at<float>(60, 80), 0.5F);
  // The corner sees what is beside the ideal image.
  EXPECT_TRUE(std::isnan(trace.depth_m.at<float>(0, 0)));
  EXPECT_EQ(trace.voxels.voxel_of_pixel.at<int>(0, 0), -1);
  EXPECT_EQ(trace.depth_saliency.at<float>(0, 0), 0);
  EXPECT_TRUE(trace.color_saliency.empty());
}

}  // namespace
}  // namespace fovea
