#include "core/objects/mask_holes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <opencv2/imgproc.hpp>

#include "core/detector.h"

namespace fovea {
namespace {

const cv::Scalar kTableLab(100, 128, 128), kPaleLab(220, 128, 128);

// Rings of colour on a table that shows through them.
class MaskHoles : public testing::Test {
 protected:
  void AddRing(int label, const cv::Point& middle, int radius_px, const cv::Scalar& color) {
    cv::circle(labels_, middle, radius_px, label, 3, cv::LINE_4);
    cv::circle(lab_, middle, radius_px, color, 3, cv::LINE_4);
  }

  int LabelAt(const cv::Point& pixel) const { return labels_.at<std::uint16_t>(pixel); }

  cv::Mat lab_{60, 80, CV_8UC3, kTableLab};
  cv::Mat labels_ = cv::Mat::zeros(60, 80, CV_16UC1);
};

TEST_F(MaskHoles, AreFilledWhereTheyHaveTheColorOfTheObject) {
  AddRing(2, {20, 30}, 10, kPaleLab);
  cv::circle(lab_, {20, 30}, 10, kPaleLab, cv::FILLED);
  AddRing(1, {60, 30}, 10, kPaleLab);
  FillMaskHoles(lab_, labels_);
  EXPECT_EQ(LabelAt({20, 30}), 2);
  EXPECT_EQ(LabelAt({60, 30}), 0) << "the table is seen through it";
  EXPECT_EQ(LabelAt({40, 30}), 0);
}

TEST_F(MaskHoles, CountLightnessNoMoreThanHues) {
  AddRing(1, {20, 30}, 10, {150, 128, 128});  // 20 of lightness from the table, as CIE has it
  cv::circle(lab_, {20, 30}, 6, {150, 152, 128},
             cv::FILLED);  // 24 from the ring, 31 from the table
  AddRing(2, {60, 30}, 10, {150, 158, 128});
  cv::circle(lab_, {60, 30}, 6, {100, 148, 128},
             cv::FILLED);  // 22 from the ring, 20 from the table
  FillMaskHoles(lab_, labels_);
  EXPECT_EQ(LabelAt({20, 30}), 1);
  EXPECT_EQ(LabelAt({60, 30}), 0);
}

TEST_F(MaskHoles, HaveToBeEnclosedByOneObject) {
  AddRing(1, {20, 30}, 10, kPaleLab);
  cv::circle(lab_, {20, 30}, 10, kPaleLab, cv::FILLED);
  labels_(cv::Rect(25, 28, 20, 4)) = 0;  // a way out
  FillMaskHoles(lab_, labels_);
  EXPECT_EQ(LabelAt({20, 30}), 0);
  labels_(cv::Rect(25, 20, 8, 20)) = 2;  // closed by another one
  FillMaskHoles(lab_, labels_);
  EXPECT_EQ(LabelAt({20, 30}), 0);
}

TEST_F(MaskHoles, AreNoneOfWhatGoesOnBeyondTheImage) {
  AddRing(1, {3, 30}, 10, kPaleLab);
  cv::circle(lab_, {3, 30}, 10, kPaleLab, cv::FILLED);
  FillMaskHoles(lab_, labels_);
  EXPECT_EQ(LabelAt({1, 30}), 0);
}

TEST_F(MaskHoles, KeepWhatLiesInThem) {
  AddRing(3, {40, 30}, 24, kPaleLab);
  cv::circle(lab_, {40, 30}, 22, kPaleLab, cv::FILLED);
  const cv::Scalar red(110, 200, 180);
  AddRing(1, {40, 30}, 10, red);
  FillMaskHoles(lab_, labels_);
  EXPECT_EQ(LabelAt({40, 30}), 3) << "through a red ring on a plate the plate is seen";
  EXPECT_EQ(LabelAt({40, 20}), 1);
  EXPECT_EQ(LabelAt({40, 12}), 3);
}

TEST_F(MaskHoles, AreAskedOfTheSmallerObjectFirst) {
  AddRing(1, {40, 30}, 24, kPaleLab);
  const cv::Scalar grey(160, 128, 128);
  AddRing(2, {40, 30}, 10, grey);
  cv::circle(lab_, {40, 30}, 10, grey, cv::FILLED);
  FillMaskHoles(lab_, labels_);
  EXPECT_EQ(LabelAt({40, 30}), 2) << "to the other it is nearer than to the table, too";
  EXPECT_EQ(LabelAt({40, 12}), 0);
}

TEST_F(MaskHoles, StayWhereNothingTellsThemApart) {
  AddRing(1, {20, 30}, 10, kTableLab);
  FillMaskHoles(lab_, labels_);
  EXPECT_EQ(LabelAt({20, 30}), 0);
  labels_ = 1;  // nothing is around it
  labels_(cv::Rect(30, 30, 4, 4)) = 0;
  FillMaskHoles(lab_, labels_);
  EXPECT_EQ(LabelAt({31, 31}), 0);
}

// Seen from above: a rim 15 mm high and 4 cm wide, within which is the height of the table.
TEST(MaskOfAPlate, IsWhole) {
  RgbdFrame frame{cv::Mat(480, 640, CV_8UC3, cv::Scalar(90, 90, 90)),
                  cv::Mat(480, 640, CV_32FC1, cv::Scalar(0.8F)),
                  {525, 525, 319.5, 239.5},
                  Eigen::Vector3f(0, 0, 1)};
  const cv::Point middle(330, 250);
  for (cv::Point pixel; pixel.y < 480; ++pixel.y) {
    for (pixel.x = 0; pixel.x < 640; ++pixel.x) {
      const double radius_m = 0.8 / 525 * cv::norm(pixel - middle);
      if (radius_m > 0.12) continue;
      frame.color_rgb.at<cv::Vec3b>(pixel) = {210, 210, 200};
      if (radius_m > 0.08) frame.depth_m.at<float>(pixel) = 0.785F;
    }
  }
  const Detections found = Detect(frame, OptionsOfProfile("default"));
  ASSERT_EQ(found.objects.size(), 1U);
  EXPECT_EQ(found.labels.at<std::uint16_t>(middle), 1);
}

}  // namespace
}  // namespace fovea
