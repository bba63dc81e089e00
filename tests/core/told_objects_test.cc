// What a detection tells beside its objects: what a region cut, what was rejected, what is odd,
// what must be moved first.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/core.hpp>
#include <vector>

#include "core/detector.h"
#include "tests/core/tabletop.h"

namespace fovea {
namespace {

using scenes::Tabletop;
using scenes::TabletopTruth;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Detect, SaysThatARegionMayShutEverythingOut) {
  DetectorOptions options = OptionsOfProfile("default");
  options.region.max_z_m = 0.1;  // just before the camera
  EXPECT_THAT(Detect(Tabletop(), options).diagnostics.messages, Contains(HasSubstr("region.*")));
}

// Of the objects that lie for the most part in a part of the image.
std::vector<bool> TruncatedIn(const Detections& found, const cv::Rect& part) {
  std::vector<bool> truncated;
  for (const DetectedObject& object : found.objects) {
    const int num = cv::countNonZero(found.labels(part) == object.label);
    if (2 * num > static_cast<int>(object.num_pixels)) truncated.push_back(object.truncated);
  }
  return truncated;
}

TEST(Detect, WhatARegionCutsIsTruncated) {
  const RgbdFrame frame = TabletopTruth().frame;
  DetectorOptions options = OptionsOfProfile("default");
  const Detections whole = Detect(frame, options);
  const auto largest = std::max_element(
      whole.objects.begin(), whole.objects.end(), [](const auto& a, const auto& b) {
        return (a.truncated ? 0 : a.num_pixels) < (b.truncated ? 0 : b.num_pixels);
      });
  ASSERT_NE(largest, whole.objects.end());
  ASSERT_FALSE(largest->truncated);
  const cv::Rect& bounds = largest->bounds_px;
  const auto with_left_end_at = [&](int x_px) {
    options.region.x_px = x_px;
    return TruncatedIn(Detect(frame, options), bounds);
  };
  EXPECT_THAT(with_left_end_at(bounds.x + bounds.width / 4), ElementsAre(true));
  EXPECT_THAT(with_left_end_at(bounds.x - 10), ElementsAre(false));
}

TEST(Detect, TellsWhatItRejectedAndWhy) {
  DetectorOptions options = OptionsOfProfile("default");
  const RgbdFrame frame = Tabletop();
  const std::size_t num_objects = Detect(frame, options).objects.size();
  options.choice.min_probability = 1;
  const Detections found = Detect(frame, options);
  EXPECT_TRUE(found.objects.empty());
  ASSERT_GE(found.rejected.size(), num_objects);
  EXPECT_EQ(found.diagnostics.segments_implausible, found.rejected.size());
  EXPECT_GT(found.rejected.front().probability, 0.5F);
  EXPECT_FALSE(found.rejected.front().reason.empty());
  EXPECT_THAT(found.diagnostics.messages, Contains(HasSubstr("considered")));
}

// Whose blocks are of several pixels.
TEST(Detect, TellsWhereInPixelsItIsThatItRejected) {
  DetectorOptions options = OptionsOfProfile("default");
  options.voxels.size_m = 0.02;
  const RgbdFrame frame = TabletopTruth().frame;
  const auto objects = Detect(frame, options).objects;
  ASSERT_FALSE(objects.empty());
  options.choice.min_probability = 1;
  const auto rejected = Detect(frame, options).rejected;
  const cv::Rect& found = objects.front().bounds_px;
  EXPECT_TRUE(std::any_of(rejected.begin(), rejected.end(), [&](const RejectedObject& other) {
    return 2 * (other.bounds_px & found).area() > (other.bounds_px | found).area();
  })) << found;
}

TEST(Detect, SaysThatAnImageOfOneColorShowsNothing) {
  RgbdFrame frame = Tabletop();
  frame.color_rgb.setTo(cv::Scalar(90, 60, 30));
  const Detections found = Detect(frame, OptionsOfProfile("default"));
  EXPECT_THAT(found.diagnostics.messages, Contains(HasSubstr("image shows nothing")));
}

TEST(Detect, WhatCarriesIsBlockedByWhatStandsOnIt) {
  const RgbdFrame frame =
      scenes::MakeFrame(scenes::RandomScene("stacked", 1), scenes::SensorKind::kIdeal, 1).frame;
  const auto objects = Detect(frame, OptionsOfProfile("default")).objects;
  int num_carried = 0;
  for (const DetectedObject& object : objects) {
    for (const int label : object.stands_on) {
      if (label == 0) continue;
      ++num_carried;
      EXPECT_THAT(objects[static_cast<std::size_t>(label) - 1].blocked_by, Contains(object.label));
    }
  }
  EXPECT_GT(num_carried, 0);
}

}  // namespace
}  // namespace fovea
