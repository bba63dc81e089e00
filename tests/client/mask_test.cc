#include "client/mask.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <random>
#include <stdexcept>

#include "client/cli/labels.h"
#include "server/conversion/mask.h"

namespace fovea::client {
namespace {

using ::testing::ElementsAre;

v1::Mask MaskOf(std::uint32_t width, std::uint32_t height, std::initializer_list<int> runs) {
  v1::Mask mask;
  mask.mutable_bounds()->set_width(width);
  mask.mutable_bounds()->set_height(height);
  for (const int run : runs) mask.add_runs(static_cast<std::uint32_t>(run));
  return mask;
}

TEST(DecodeMask, StartsWithBackground) {
  EXPECT_THAT(DecodeMask(MaskOf(3, 2, {1, 4, 1})), ElementsAre(0, 1, 1, 1, 1, 0));
  EXPECT_THAT(DecodeMask(MaskOf(2, 1, {0, 2})), ElementsAre(1, 1));
}

TEST(DecodeMask, SaysHowToAskForAMaskThatIsNotThere) {
  const auto decode = [] { DecodeMask(v1::Object().mask()); };
  EXPECT_THAT(decode, ::testing::ThrowsMessage<std::invalid_argument>(
                          "there is no mask: DetectOptions.return_masks asks for it"));
}

TEST(DecodeMask, RefusesRunsThatDoNotFit) {
  EXPECT_THROW(DecodeMask(MaskOf(3, 2, {1, 4})), std::invalid_argument);
  EXPECT_THROW(DecodeMask(MaskOf(3, 2, {1, 6})), std::invalid_argument);
  EXPECT_THROW(DecodeMask(MaskOf(1, 1, {-1, -1, 3})), std::invalid_argument);  // wraps in 32 bits
}

TEST(DecodeMask, UndoesTheServersEncoding) {
  std::mt19937 random(1);
  for (int i = 0; i < 50; ++i) {
    cv::Mat labels(9, 14, CV_16UC1);
    for (auto it = labels.begin<std::uint16_t>(); it != labels.end<std::uint16_t>(); ++it) {
      *it = static_cast<std::uint16_t>(random() % 3);
    }
    const cv::Rect bounds(3, 2, 8, 5);
    v1::Object object;
    *object.mutable_mask() = server::MaskToProto(labels, 2, bounds);
    const cv::Mat expected = labels(bounds) == 2;
    EXPECT_EQ(cv::norm(cli::MaskImage(object), expected, cv::NORM_INF), 0);
  }
}

v1::Detections RowOfObjects(std::uint32_t count) {
  v1::Detections detections;
  detections.set_width(count);
  detections.set_height(1);
  for (std::uint32_t label = 1; label <= count; ++label) {
    v1::Object& object = *detections.add_objects();
    object.set_label(label);
    *object.mutable_mask() = MaskOf(1, 1, {0, 1});
    object.mutable_mask()->mutable_bounds()->set_x(label - 1);
  }
  return detections;
}

TEST(LabelImage, IsAsWideAsTheNumberOfObjectsNeeds) {
  const cv::Mat narrow = cli::LabelImage(RowOfObjects(255));
  EXPECT_EQ(narrow.type(), CV_8UC1);
  EXPECT_EQ(narrow.at<std::uint8_t>(254), 255);
  const cv::Mat wide = cli::LabelImage(RowOfObjects(256));
  EXPECT_EQ(wide.type(), CV_16UC1);
  EXPECT_EQ(wide.at<std::uint16_t>(255), 256);
}

TEST(LabelImage, RefusesObjectsOutsideOfTheFrame) {
  v1::Detections detections = RowOfObjects(3);
  detections.mutable_objects(2)->mutable_mask()->mutable_bounds()->set_x(0xFFFFFFFF);
  EXPECT_THROW(cli::LabelImage(detections), std::runtime_error);
}

}  // namespace
}  // namespace fovea::client
