#include "core/tracking/still_view.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "tests/core/tracking/table_view.h"

namespace fovea {
namespace {

using testing::View;

SmallView SmallOf(const View& view) { return SmallViewOf(view.frame, view.detections.labels); }

TEST(IsSameView, KnowsNoiseAndExposureFromMotion) {
  const auto small = [](double x_m, std::uint64_t seed, double gain = 1) {
    View view(x_m, seed);
    view.frame.color_rgb *= gain;
    return SmallViewOf(view.frame, view.detections.labels);
  };
  EXPECT_TRUE(IsSameView(small(0, 1), small(0, 2)));
  EXPECT_TRUE(IsSameView(small(0, 1), small(0, 2, 0.95)));
  EXPECT_FALSE(IsSameView(small(0, 1), small(1 / 250.0, 2))) << "one pixel";
  EXPECT_FALSE(IsSameView(small(0, 1), small(0.3, 2)));
  View blank;
  blank.frame.color_rgb.setTo(cv::Scalar::all(128));
  const SmallView nothing = SmallViewOf(blank.frame, blank.detections.labels);
  EXPECT_FALSE(IsSameView(nothing, nothing)) << "that cannot be told without contrast";
}

// Tiles, gravel, a carpet: no shift of a fraction of a pixel explains what changed, so that none is
// found, by thousands of pixels.
TEST(IsSameView, IsNotAnotherPartOfAFineTexture) {
  const auto seen = [](std::uint64_t texture, std::uint64_t noise, double contrast) {
    View view(0, noise);
    cv::RNG random(texture);
    cv::Mat tiles(60, 80, CV_8UC1);
    random.fill(tiles, cv::RNG::UNIFORM, 128 - contrast, 128 + contrast);
    cv::resize(tiles, tiles, testing::kSize, 0, 0, cv::INTER_NEAREST);
    cv::Mat change(testing::kSize, CV_8UC3);
    cv::RNG(noise).fill(change, cv::RNG::NORMAL, 8, 3);
    cv::cvtColor(tiles, view.frame.color_rgb, cv::COLOR_GRAY2RGB);
    view.frame.color_rgb += change;
    return SmallOf(view);
  };
  for (const double contrast : {6, 10, 15}) {
    EXPECT_TRUE(IsSameView(seen(1, 1, contrast), seen(1, 2, contrast))) << contrast;
    EXPECT_FALSE(IsSameView(seen(1, 1, contrast), seen(2, 2, contrast))) << contrast;
  }
}

// 160 pixels wide at the image's own proportions it would have millions of rows.
TEST(SmallView, IsSmallHoweverNarrowTheImage) {
  RgbdFrame ribbon;
  ribbon.color_rgb = cv::Mat(2000, 1, CV_8UC3, cv::Scalar::all(90));
  const SmallView view = SmallViewOf(ribbon, cv::Mat::zeros(2000, 1, CV_16UC1));
  EXPECT_LE(view.gray.rows, 640);
  EXPECT_EQ(view.movable.size(), view.gray.size());
}

// 320 pixels wide: a third of a pixel at 640 is 0.165 of them.
TEST(IsSameView, IsNeitherShiftedNorTurnedNorScaled) {
  const auto seen = [](double shift_px, double turn_deg = 0, double scale = 1) {
    View view(0, turn_deg != 0 || scale != 1 || shift_px != 0);
    cv::Mat affine = cv::getRotationMatrix2D({159.5F, 119.5F}, turn_deg, scale);
    affine.at<double>(0, 2) += shift_px;
    cv::warpAffine(view.frame.color_rgb, view.frame.color_rgb, affine, testing::kSize,
                   cv::INTER_LINEAR, cv::BORDER_REFLECT);
    return SmallOf(view);
  };
  const SmallView first = seen(0);
  EXPECT_TRUE(IsSameView(first, seen(0.1)));
  EXPECT_FALSE(IsSameView(first, seen(0.25)));
  EXPECT_TRUE(IsSameView(first, seen(0, 0.03))) << "0.08 px at the edge";
  EXPECT_FALSE(IsSameView(first, seen(0, 0.1))) << "0.28 px at the edge";
  EXPECT_FALSE(IsSameView(first, seen(0, 0, 1.002))) << "0.32 px at the edge";
}

TEST(IsSameView, WhereThingsComeAndGo) {
  View left(0, 1), right(0, 2), unknown(0, 3);
  left.Add({-0.2F, 0, 0.8F}, testing::kRed, 0.35F);
  right.Add({0.2F, 0, 0.8F}, testing::kBlue, 0.35F);
  unknown.Add({0.2F, 0, 0.8F}, testing::kBlue, 0.35F);
  unknown.detections.labels = 0;
  EXPECT_TRUE(IsSameView(SmallOf(left), SmallOf(right)));
  EXPECT_FALSE(IsSameView(SmallOf(View()), SmallOf(unknown))) << "a sixth has changed";
}

// A hand that is no object, darker than a table of little contrast by less than what counts as a
// change at once.
TEST(IsSameView, WhereAHandIsLikeTheTable) {
  const auto seen = [](bool with_hand, double shift_px) {
    View view;
    const cv::Mat shift = (cv::Mat_<double>(2, 3) << 1, 0, shift_px, 0, 1, 0);
    cv::warpAffine(view.frame.color_rgb, view.frame.color_rgb, shift, testing::kSize,
                   cv::INTER_LINEAR, cv::BORDER_REFLECT);
    view.frame.color_rgb.convertTo(view.frame.color_rgb, CV_8UC3, 0.2, 100);
    if (with_hand) view.frame.color_rgb(cv::Rect(40, 0, 30, 140)) -= cv::Scalar::all(20);
    return SmallOf(view);
  };
  EXPECT_TRUE(IsSameView(seen(false, 0), seen(true, 0)));
  EXPECT_FALSE(IsSameView(seen(false, 0), seen(true, 0.25)));
}

TEST(IsSameView, TakesAFifthOfTheImageAtLeast) {
  for (const double share : {0.7, 0.85}) {
    View view(0, 1);
    view.detections.labels.colRange(0, cvRound(share * 320)) = 1;
    EXPECT_EQ(IsSameView(SmallOf(view), SmallOf(view)), share < 0.8) << share;
  }
}

TEST(IsSameView, ImagesOfAnotherShapeAreAnotherView) {
  const View view;
  View wide;
  wide.frame.color_rgb = wide.frame.color_rgb.rowRange(0, 180);
  wide.detections.labels = wide.detections.labels.rowRange(0, 180);
  EXPECT_FALSE(IsSameView(SmallOf(wide), SmallOf(view)));
}

// Along stripes nothing tells, and little where there is one small mark on a wall.
TEST(IsSameView, CannotBeToldWithoutContrastInEachDirection) {
  View stripes, mark;
  stripes.frame.color_rgb.setTo(cv::Scalar::all(128));
  mark.frame.color_rgb.setTo(cv::Scalar::all(128));
  for (int x = -240; x < 320; x += 40) {
    cv::line(stripes.frame.color_rgb, {x - 40, -40}, {x + 280, 280}, cv::Scalar::all(160), 10);
  }
  cv::circle(mark.frame.color_rgb, {60, 60}, 4, cv::Scalar::all(136), cv::FILLED);
  EXPECT_FALSE(IsSameView(SmallOf(stripes), SmallOf(stripes)));
  EXPECT_FALSE(IsSameView(SmallOf(mark), SmallOf(mark)));
}

// Two by two pixels are one of the small view, and what is near things may be their shadow.
TEST(SmallView, IsSmoothAndWhatIsNearThingsMayMove) {
  View view;
  view.frame.color_rgb.setTo(cv::Scalar::all(0));
  view.frame.color_rgb(cv::Rect(100, 80, 2, 2)) = cv::Scalar::all(240);
  view.detections.labels(cv::Rect(200, 100, 20, 10)) = 1;
  const SmallView small = SmallOf(view);
  EXPECT_EQ(small.gray.at<float>(40, 50), 60);
  EXPECT_EQ(small.gray.at<float>(40, 51), 30);
  EXPECT_EQ(small.gray.at<float>(41, 50), 30);
  EXPECT_EQ(cv::boundingRect(small.movable), cv::Rect(98, 48, 14, 9));
}

}  // namespace
}  // namespace fovea
