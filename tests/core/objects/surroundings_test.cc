#include "core/objects/surroundings.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/core/objects/test_scene.h"

namespace fovea {
namespace {

const cv::Rect kThing(80, 40, 20, 30);

TEST(Surroundings, InTheOpenEverythingIsFartherAway) {
  TestScene scene(2);
  scene.Put(kThing, 1, 1);
  const LabelledScene labelled = scene.Labelled();
  const BorderCounts counts = FindSurroundings(labelled, scene.labels).at(1).counts;
  EXPECT_EQ(counts.Total(), 100);
  EXPECT_EQ(counts.Of(Beyond::kFarther), 100);
  EXPECT_EQ(counts.Of(BorderSide::kAbove), 20);
  EXPECT_EQ(counts.Of(BorderSide::kBelow), 20);
  EXPECT_EQ(counts.Of(BorderSide::kBeside), 60);
}

TEST(Surroundings, BackgroundAtTheSameDistanceIsLevelOrRisesOrIsWall) {
  TestScene scene(1);
  scene.Put(kThing, 1, 1);
  LabelledScene labelled = scene.Labelled();
  BorderCounts counts = FindSurroundings(labelled, scene.labels).at(1).counts;
  EXPECT_EQ(counts.At(BorderSide::kAbove, Beyond::kRising), 20);
  EXPECT_EQ(counts.At(BorderSide::kBeside, Beyond::kLevel), 60);
  EXPECT_EQ(counts.At(BorderSide::kBelow, Beyond::kLevel), 20);
  scene.wall = {0, 0, 200, 60};
  const LabelledScene with_wall = scene.Labelled();
  counts = FindSurroundings(with_wall, scene.labels).at(1).counts;
  EXPECT_EQ(counts.At(BorderSide::kAbove, Beyond::kWall), 20);
}

TEST(Surroundings, WhatIsInFrontAndWhatIsNotMeasured) {
  TestScene scene(2);
  scene.Put(kThing, 1, 1);
  scene.Put({100, 40, 60, 30}, 0.5F, 0);
  scene.Put({20, 40, 60, 30}, std::numeric_limits<float>::quiet_NaN(), 0);
  const LabelledScene labelled = scene.Labelled();
  const BorderCounts counts = FindSurroundings(labelled, scene.labels).at(1).counts;
  EXPECT_EQ(counts.At(BorderSide::kBeside, Beyond::kNearer), 30);
  EXPECT_EQ(counts.At(BorderSide::kBeside, Beyond::kUnmeasured), 30);
}

TEST(Surroundings, TheEndOfTheImage) {
  TestScene scene(2);
  scene.Put({0, 40, 20, 30}, 1, 1);
  const LabelledScene labelled = scene.Labelled();
  const BorderCounts counts = FindSurroundings(labelled, scene.labels).at(1).counts;
  EXPECT_EQ(counts.At(BorderSide::kBeside, Beyond::kEnd), 30);
}

TEST(Surroundings, WhereTheCameraDoesNotLook) {
  TestScene scene(2);
  scene.Put({30, 40, 20, 30}, 1, 1);
  scene.unseen = cv::Mat::zeros(scene.labels.size(), CV_8UC1);
  scene.unseen(cv::Rect(0, 0, 30, 120)).setTo(255);
  const LabelledScene labelled = scene.Labelled();
  const BorderCounts counts = FindSurroundings(labelled, scene.labels).at(1).counts;
  EXPECT_EQ(counts.At(BorderSide::kBeside, Beyond::kEnd), 30);
  EXPECT_EQ(counts.Of(Beyond::kEnd), 30);
}

TEST(Surroundings, OtherSegmentsAreCountedByLabel) {
  TestScene scene(2);
  scene.Put(kThing, 1, 1);
  scene.Put({100, 40, 20, 30}, 1, 2);
  scene.Put({60, 40, 20, 30}, 0.7F, 3);
  const LabelledScene labelled = scene.Labelled();
  const auto surroundings = FindSurroundings(labelled, scene.labels);
  const Surroundings& own = surroundings.at(1);
  EXPECT_EQ(own.counts.Of(Beyond::kLevelSegment), 30);
  EXPECT_EQ(own.counts.Of(Beyond::kNearerSegment), 30);
  EXPECT_EQ(own.towards.at(2).Total(), 30);
  EXPECT_EQ(own.towards.at(3).Total(), 30);
  EXPECT_EQ(surroundings.at(3).counts.Of(Beyond::kFarther), 100);
}

TEST(Surroundings, ContrastIsToBackgroundAtTheSameDistance) {
  TestScene alike(1), other(1);
  alike.Put(kThing, 1, 1);
  other.Put(kThing, 1, 1);
  other.lab(kThing).setTo(cv::Scalar(109, 190, 170));
  const LabelledScene first = alike.Labelled(), second = other.Labelled();
  EXPECT_EQ(FindSurroundings(first, alike.labels).at(1).counts.contrast, 0);
  EXPECT_GT(FindSurroundings(second, other.labels).at(1).counts.contrast, 100 * 30);
}

}  // namespace
}  // namespace fovea
