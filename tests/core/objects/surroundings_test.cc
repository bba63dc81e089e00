#include "core/objects/surroundings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/core/objects/test_scene.h"

namespace fovea {
namespace {

const cv::Rect kThing(80, 40, 20, 30);

std::ptrdiff_t CountFacings(const Surroundings& surroundings, int own, int other) {
  return std::count_if(
      surroundings.facings.begin(), surroundings.facings.end(),
      [&](const Facing& facing) { return facing.own == own && facing.other == other; });
}

TEST(Surroundings, InTheOpenEverythingIsFartherAway) {
  TestScene scene(2);
  scene.Put(kThing, 1, 1);
  const LabelledScene labelled = scene.Labelled();
  const BorderCounts counts = FindSurroundings(labelled, scene.labels).counts.at(1);
  EXPECT_EQ(counts.Total(), 100);
  EXPECT_EQ(counts.Of(Beyond::kFarther), 100);
  EXPECT_EQ(counts.Of(BorderSide::kAbove), 20);
  EXPECT_EQ(counts.Of(BorderSide::kElsewhere), 80);
}

TEST(Surroundings, SidesGoByGravity) {
  TestScene scene(2);
  scene.Put(kThing, 1, 1);
  LabelledScene labelled = scene.Labelled();
  const auto count = [&](const Eigen::Vector3f& up, BorderSide side) {
    labelled.up = up;
    return FindSurroundings(labelled, scene.labels).counts.at(1).Of(side);
  };
  const Eigen::Vector3f askew(-std::sqrt(0.5F), -std::sqrt(0.5F), 0);  // up and to the left
  EXPECT_EQ(count(askew, BorderSide::kAbove), 20 + 30);
  EXPECT_EQ(count(askew, BorderSide::kElsewhere), 20 + 30);
  const Eigen::Vector3f into_the_image(0, 0, -1);  // it looks straight down
  EXPECT_EQ(count(into_the_image, BorderSide::kElsewhere), 100);
}

TEST(Surroundings, BackgroundAtTheSameDistanceIsLevelOrRisesOrIsWall) {
  TestScene scene(1);
  scene.Put(kThing, 1, 1);
  LabelledScene labelled = scene.Labelled();
  BorderCounts counts = FindSurroundings(labelled, scene.labels).counts.at(1);
  EXPECT_EQ(counts.At(BorderSide::kAbove, Beyond::kRising), 20);
  EXPECT_EQ(counts.At(BorderSide::kElsewhere, Beyond::kLevel), 60 + 20);
  scene.wall = {0, 0, 200, 60};
  const LabelledScene with_wall = scene.Labelled();
  counts = FindSurroundings(with_wall, scene.labels).counts.at(1);
  EXPECT_EQ(counts.At(BorderSide::kAbove, Beyond::kWall), 20);
}

// Depth is no more exact than that.
TEST(Surroundings, SomeMillimetersAreNoRise) {
  TestScene scene(1);
  scene.Put(kThing, 1, 1);
  cv::Mat(scene.points, {100, 40, 60, 30}) -= cv::Scalar(0, 0.003, 0);
  cv::Mat(scene.points, {20, 40, 60, 30}) -= cv::Scalar(0, 0.005, 0);
  const LabelledScene labelled = scene.Labelled();
  const BorderCounts counts = FindSurroundings(labelled, scene.labels).counts.at(1);
  EXPECT_EQ(counts.At(BorderSide::kElsewhere, Beyond::kLevel), 30 + 20);
  EXPECT_EQ(counts.At(BorderSide::kElsewhere, Beyond::kRising), 30);
}

TEST(Surroundings, WhatIsInFrontAndWhatIsNotMeasured) {
  TestScene scene(2);
  scene.Put(kThing, 1, 1);
  scene.Put({100, 40, 60, 30}, 0.5F, 0);
  scene.Put({20, 40, 60, 30}, std::numeric_limits<float>::quiet_NaN(), 0);
  const LabelledScene labelled = scene.Labelled();
  const BorderCounts counts = FindSurroundings(labelled, scene.labels).counts.at(1);
  EXPECT_EQ(counts.At(BorderSide::kElsewhere, Beyond::kNearer), 30);
  EXPECT_EQ(counts.At(BorderSide::kElsewhere, Beyond::kUnmeasured), 30);
}

// 40 pixels of 640 are 12 of 200.
TEST(Surroundings, LooksAcrossWhatIsNotMeasuredWithinReach) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  TestScene scene(2);
  scene.Put(kThing, 1, 1);
  scene.Put({100, 40, 11, 30}, nan, 0);
  scene.Put({68, 40, 12, 30}, nan, 0);
  const LabelledScene labelled = scene.Labelled();
  const BorderCounts counts = FindSurroundings(labelled, scene.labels).counts.at(1);
  EXPECT_EQ(counts.At(BorderSide::kElsewhere, Beyond::kFarther), 30 + 20);
  EXPECT_EQ(counts.At(BorderSide::kElsewhere, Beyond::kUnmeasured), 30);
}

TEST(Surroundings, AGapInAThingIsNoBorder) {
  TestScene scene(2);
  scene.Put(kThing, 1, 1);
  scene.Put({85, 50, 5, 5}, std::numeric_limits<float>::quiet_NaN(), 0);
  const LabelledScene labelled = scene.Labelled();
  EXPECT_EQ(FindSurroundings(labelled, scene.labels).counts.at(1).Total(), 100);
}

// Or a pixel before it, where sensors mix.
TEST(Surroundings, TheEndOfTheImage) {
  for (const int left : {0, 1}) {
    TestScene scene(2);
    scene.Put({left, 40, 20, 30}, 1, 1);
    const LabelledScene labelled = scene.Labelled();
    const BorderCounts counts = FindSurroundings(labelled, scene.labels).counts.at(1);
    EXPECT_EQ(counts.At(BorderSide::kElsewhere, Beyond::kEnd), 30);
  }
}

TEST(Surroundings, WhereTheCameraDoesNotLook) {
  TestScene scene(2);
  scene.Put({30, 40, 20, 30}, 1, 1);
  scene.unseen = cv::Mat::zeros(scene.labels.size(), CV_8UC1);
  scene.unseen(cv::Rect(0, 0, 30, 120)).setTo(255);
  const LabelledScene labelled = scene.Labelled();
  const BorderCounts counts = FindSurroundings(labelled, scene.labels).counts.at(1);
  EXPECT_EQ(counts.At(BorderSide::kElsewhere, Beyond::kEnd), 30);
  EXPECT_EQ(counts.Of(Beyond::kEnd), 30);
}

TEST(Surroundings, OtherSegmentsAreCountedByLabel) {
  TestScene scene(2);
  scene.Put(kThing, 1, 1);
  scene.Put({100, 40, 20, 30}, 1, 2);
  scene.Put({60, 40, 20, 30}, 0.7F, 3);
  const LabelledScene labelled = scene.Labelled();
  const auto surroundings = FindSurroundings(labelled, scene.labels);
  const BorderCounts& own = surroundings.counts.at(1);
  EXPECT_EQ(own.Of(Beyond::kLevelSegment), 30);
  EXPECT_EQ(own.Of(Beyond::kNearerSegment), 30);
  EXPECT_EQ(CountFacings(surroundings, 1, 2), 30);
  EXPECT_EQ(CountFacings(surroundings, 1, 3), 30);
  EXPECT_EQ(surroundings.counts.at(3).Of(Beyond::kFarther), 100);
}

// Only background may be what sensors mix at an edge.
TEST(Surroundings, SeesSegmentsOfOnePixel) {
  TestScene scene(2);
  scene.Put(kThing, 1, 1);
  scene.Put({100, 40, 1, 30}, 1, 2);
  const LabelledScene labelled = scene.Labelled();
  EXPECT_EQ(CountFacings(FindSurroundings(labelled, scene.labels), 1, 2), 30);
}

TEST(Surroundings, ContrastIsToBackgroundAtTheSameDistance) {
  TestScene alike(1), other(1);
  alike.Put(kThing, 1, 1);
  other.Put(kThing, 1, 1);
  other.lab(kThing).setTo(cv::Scalar(109, 190, 170));
  const LabelledScene first = alike.Labelled(), second = other.Labelled();
  EXPECT_EQ(FindSurroundings(first, alike.labels).counts.at(1).contrast, 0);
  EXPECT_GT(FindSurroundings(second, other.labels).counts.at(1).contrast, 100 * 30);
}

// A thing of one pixel of the colour of the background, beside another that is 100 units lighter:
// as colours are blurred over 5 pixels, it gets 2/5 of that, and none the background 2 pixels on.
TEST(Surroundings, ContrastIsFromTheThingItself) {
  TestScene scene(1);
  scene.Put({100, 40, 1, 30}, 1, 1);
  scene.Put({80, 40, 20, 30}, 1, 2);
  scene.lab(cv::Rect(80, 0, 20, 120)).setTo(cv::Scalar(208, 128, 128));
  const LabelledScene labelled = scene.Labelled();
  EXPECT_EQ(FindSurroundings(labelled, scene.labels).counts.at(1).contrast, 40 * 30);
}

TEST(Surroundings, InGreyFramesWhatIsUsualOfContrastIsAddedToIt) {
  TestScene scene(1);
  scene.Put(kThing, 1, 1);
  const LabelledScene labelled = scene.Labelled();
  const auto contrast = [&](bool is_grey) {
    for (MeanColor& color : scene.colors) color.is_grey = is_grey;
    return FindSurroundings(labelled, scene.labels).counts.at(1).contrast;
  };
  EXPECT_NEAR(contrast(true), 100 * kUsualContrast, 1e-9);
  scene.lab(kThing) += cv::Scalar(40, 0, 0);
  EXPECT_GT(contrast(true), contrast(false));
  EXPECT_LT(contrast(true), contrast(false) + 100 * kUsualContrast);
}

}  // namespace
}  // namespace fovea
