#include "core/lens/distort_answer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/lens/undistortion.h"

namespace fovea {
namespace {

const cv::Size kSize(160, 120);
// Bends the corners inwards by some eight pixels.
Lens Barrel() {
  return {{130, 130, 79.5, 59.5},
          {LensDistortion::Model::kBrownConrady, {-0.15, 0.01, 0.001, 0.002}},
          kSize};
}

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
  const Lens lens({130, 130, 79.5, 59.5}, {LensDistortion::Model::kBrownConrady, {0.3}}, kSize);
  Detections answer = AnswerWithDisk({157, 117}, 2);
  Trace trace;
  DistortAnswer(lens, answer, trace);
  EXPECT_EQ(answer.objects.front().num_pixels, 0U);
  EXPECT_EQ(answer.objects.front().bounds_px, cv::Rect(159, 119, 1, 1));
}

TEST(DistortAnswer, TakesSeedsRejectedAndImagesAlong) {
  const Lens lens = Barrel();
  Detections answer;
  answer.labels = cv::Mat::zeros(kSize, CV_16UC1);
  answer.rejected.push_back({cv::Rect(130, 90, 20, 20), 0.1F, "small"});
  Trace trace;
  trace.seeds.resize(1);
  trace.seeds[0].pixel = {150, 110};
  trace.depth_m = cv::Mat(kSize, CV_32FC1, cv::Scalar(2));
  trace.depth_m.at<float>(110, 150) = 1;
  trace.voxels.voxel_of_pixel = cv::Mat(kSize, CV_32SC1, cv::Scalar(7));
  DistortAnswer(lens, answer, trace);

  const cv::Point expected = lens.Distort({150, 110});
  EXPECT_EQ(trace.seeds[0].pixel, expected);
  EXPECT_EQ(trace.depth_m.at<float>(expected), 1);
  EXPECT_LE(cv::norm(answer.rejected[0].bounds_px.tl() - cv::Point(lens.Distort({130, 90}))), 1.5);
  EXPECT_EQ(trace.voxels.voxel_of_pixel.at<int>(60, 80), 7);
  EXPECT_TRUE(trace.color_saliency.empty());
}

// A plane drawn by the lens itself: depth that grows with the ideal column.
TEST(UndistortDepth, IsWhatAPinholeCameraWouldSee) {
  const Lens lens = Barrel();
  cv::Mat sent(kSize, CV_32FC1), color(kSize, CV_8UC3);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const double column = lens.Undistort(cv::Point2d(x, y)).x;
      sent.at<float>(y, x) = static_cast<float>(1 + 0.01 * column);
      color.at<cv::Vec3b>(y, x) = cv::Vec3b::all(cv::saturate_cast<std::uint8_t>(column));
    }
  }
  const cv::Mat ideal = UndistortDepth(sent, lens), ideal_color = UndistortColor(color, lens);
  int unseen = 0;
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      if (std::isnan(ideal.at<float>(y, x))) {
        ++unseen;
        continue;
      }
      EXPECT_NEAR(ideal.at<float>(y, x), 1 + 0.01 * x, 0.01) << x << ' ' << y;
      if (!cv::Rect(2, 2, 156, 116).contains({x, y})) continue;  // next to what nobody sees
      EXPECT_NEAR(ideal_color.at<cv::Vec3b>(y, x)[0], x, 1.5) << x << ' ' << y;
    }
  }
  EXPECT_EQ(unseen, 0);  // a barrel shows more than the ideal image
}

TEST(UndistortDepth, HasNoneWhereTheCameraDoesNotLook) {
  const Lens lens({130, 130, 79.5, 59.5}, {LensDistortion::Model::kBrownConrady, {0.3}}, kSize);
  const cv::Mat ideal = UndistortDepth(cv::Mat::ones(kSize, CV_32FC1), lens);
  EXPECT_TRUE(std::isnan(ideal.at<float>(0, 0)));
  EXPECT_EQ(ideal.at<float>(60, 80), 1);
}

TEST(UnseenBy, IsWhereUndistortedDepthHasNone) {
  for (const double k1 : {0.3, 0.05, -0.2}) {
    const Lens lens({130, 130, 79.5, 59.5}, {LensDistortion::Model::kBrownConrady, {k1}}, kSize);
    const cv::Mat ideal = UndistortDepth(cv::Mat::ones(kSize, CV_32FC1), lens);
    EXPECT_EQ(cv::countNonZero(UnseenBy(lens) == (ideal == ideal)), 0) << k1;
  }
}

TEST(UndistortRect, HoldsWhatTheSentRectangleShows) {
  const Lens lens = Barrel();
  const cv::Rect sent(10, 10, 30, 20), ideal = UndistortRect(lens, sent);
  for (int y = sent.y; y < sent.br().y; ++y) {
    for (int x = sent.x; x < sent.br().x; ++x) {
      const cv::Point nearest = lens.Undistort(cv::Point2d(x, y));
      EXPECT_TRUE(ideal.contains(nearest) || !cv::Rect({0, 0}, kSize).contains(nearest)) << nearest;
    }
  }
}

}  // namespace
}  // namespace fovea
