#include "core/tracking/track.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "tests/core/tracking/followed_thing.h"

namespace fovea {
namespace {

using testing::Followed;
using testing::kStands;
using testing::ThingAt;

// Half of it is covered.
Sighting InPart(Sighting sighting) {
  sighting.visible_m2 /= 2;
  return sighting;
}

TEST(Track, APushIsToldAtOnceAndThenItStands) {
  for (const float push_m : {0.02F, 0.05F, 0.1F}) {
    SCOPED_TRACE(push_m);
    Followed thing;
    EXPECT_TRUE(thing.See(push_m).is_moving);
    EXPECT_NEAR(thing.SteadyX(), push_m, 1e-6);
    EXPECT_EQ(thing.track.ToObjectTrack().steadied_over, 1U);
    for (unsigned over = 2; over < 5; ++over) {
      const ObjectTrack after = thing.See(push_m + (over % 2 == 0 ? 0.001F : -0.001F));
      EXPECT_FALSE(after.is_moving) << over;
      EXPECT_EQ(after.steadied_over, over);
      EXPECT_NEAR(thing.SteadyX(), push_m, 0.0011) << over;
    }
  }
}

TEST(Track, WhatMovesOnIsWhereItIsSeen) {
  for (const float step_m : {0.047F, 0.017F, -0.047F}) {
    SCOPED_TRACE(step_m);
    Followed thing;
    for (int i = 1; i < 10; ++i) {
      const float x_m = step_m * static_cast<float>(i);
      EXPECT_TRUE(thing.See(x_m).is_moving) << i;
      EXPECT_NEAR(thing.SteadyX(), x_m, 1e-6) << i;
    }
  }
}

// 6 mm from frame to frame are within the noise, twice as much is not.
TEST(Track, WhatCreepsIsNotLeftBehind) {
  for (const int frames : {1, 4, 12}) {
    SCOPED_TRACE(frames);
    Followed thing(frames);
    int moving = 0;
    for (int i = 1; i < 12; ++i) {
      const float x_m = 0.006F * static_cast<float>(i);
      moving += thing.See(x_m).is_moving ? 1 : 0;
      EXPECT_NEAR(thing.SteadyX(), x_m, 0.013) << i;
    }
    EXPECT_GE(moving, 8);
    EXPECT_TRUE(thing.track.ToObjectTrack().is_moving);
    EXPECT_FALSE(thing.See(0.066F).is_moving);
  }
}

TEST(Track, NoiseWithinItsDeviationIsSteadied) {
  Followed thing(1);
  for (int i = 0; i < 40; ++i) {
    const ObjectTrack seen = thing.See(ThingAt(i % 2 == 0 ? 0.004F : 0, i % 3 == 0 ? 0.003F : 0));
    EXPECT_FALSE(seen.is_moving) << i;
    EXPECT_EQ(seen.steadied_over, std::min(i + 2U, SteadiedBox::kSteadiedOver));
  }
  EXPECT_NEAR(thing.SteadyX(), 0.002, 0.001);
}

// What jumps by as much may be pushed by as much, unseen; what has stood as still as can be not.
TEST(Track, IsBelievedTheMoreTheStillerItStood) {
  Followed still(12), restless(1);
  for (int i = 0; i < 11; ++i) restless.See(i % 2 == 0 ? 0.006F : 0);
  EXPECT_TRUE(still.See(0.009F).is_moving);
  EXPECT_FALSE(restless.See(0.012F).is_moving);
}

TEST(Track, BelievesLessWhereTheCamerasMotionIsUnsure) {
  Followed sure, unsure;
  EXPECT_TRUE(sure.See(0.03F, 0.002).is_moving);
  EXPECT_FALSE(unsure.See(0.03F, 0.01).is_moving);
}

TEST(Track, ErrorsOfTheCamerasMotionAddUpWhereNoPosesAreGiven) {
  for (const double adding_up_m : {0.0, 0.005}) {
    Followed thing;
    for (int i = 1; i < 10; ++i) {
      thing.Wait(0.1, kStands, adding_up_m);
      thing.track.OnSeen(ThingAt(0), 0.005, std::nullopt);
    }
    thing.Wait(0.1, kStands, adding_up_m);
    thing.track.OnSeen(ThingAt(0.03F), 0.005, std::nullopt);
    EXPECT_EQ(thing.track.ToObjectTrack().is_moving, adding_up_m == 0);
  }
}

// Its centroid and its middle are each where the other one is wrong.
TEST(Track, StandsWhereAnotherPartOrShapeOfItIsSeen) {
  for (const bool by_centroid : {true, false}) {
    Followed thing;
    Sighting other = ThingAt(0);
    (by_centroid ? other.centroid : other.box.center).x() = 0.05F;
    for (int i = 0; i < 3; ++i) EXPECT_FALSE(thing.See(other).is_moving);
  }
}

TEST(Track, AnotherMaskThatIsElsewhereIsLeftOutOnce) {
  Followed thing;
  EXPECT_FALSE(thing.See(InPart(ThingAt(0.04F))).is_moving);
  EXPECT_NEAR(thing.SteadyX(), 0, 1e-6) << "it may be a mistake";
  EXPECT_FALSE(thing.See(0.001F).is_moving);
  EXPECT_EQ(thing.track.ToObjectTrack().steadied_over, 5U);
  thing.See(InPart(ThingAt(0.04F)));
  EXPECT_FALSE(thing.See(InPart(ThingAt(0.041F))).is_moving) << "it stands, as another mask has it";
  EXPECT_NEAR(thing.SteadyX(), 0.041, 1e-6);
  EXPECT_EQ(thing.track.ToObjectTrack().steadied_over, 1U);
}

// As where two things that touch are taken for one now and then.
TEST(Track, StandsThoughItsMaskGoesToAndFro) {
  Followed thing;
  for (int i = 0; i < 12; ++i) {
    const bool other = i % 5 < 2 || i % 5 == 3;
    EXPECT_FALSE(thing.See(other ? InPart(ThingAt(0.04F)) : ThingAt(0)).is_moving) << i;
  }
}

TEST(Track, WhatIsHalfHiddenByAHandMovesFromItsSecondStepOn) {
  Followed thing;
  thing.See(InPart(ThingAt(0.04F)));
  EXPECT_TRUE(thing.See(InPart(ThingAt(0.08F))).is_moving);
  EXPECT_TRUE(thing.See(ThingAt(0.12F)).is_moving) << "the hand lets it go";
  EXPECT_NEAR(thing.SteadyX(), 0.12, 1e-6);
}

// The share of its diagonal of which things were said to move before uncertainties were known.
TEST(Track, WithoutUncertaintyMovesBeyondAFifthOfItsDiagonal) {
  const auto moves_at = [](float x_m) {
    Sighting vague = ThingAt(0);
    vague.uncertainty.reset();
    Track track(1, vague, std::nullopt);
    track.Advance(kStands, 0.1);
    vague.box.center.x() = vague.centroid.x() = x_m;
    track.OnSeen(vague, 0, std::nullopt);
    return track.ToObjectTrack().is_moving;
  };
  const float within_m = 0.015F + 0.2F * 0.1732F;
  EXPECT_FALSE(moves_at(0.98F * within_m));
  EXPECT_TRUE(moves_at(1.02F * within_m));
}

TEST(Track, StandsWhereOnlyTheCameraMoves) {
  Followed thing;
  thing.Wait(0.1, Eigen::Isometry3f(Eigen::Translation3f(-0.5F, 0, 0)));
  thing.track.OnSeen(ThingAt(-0.5F), 0, std::nullopt);
  EXPECT_FALSE(thing.track.ToObjectTrack().is_moving);
  EXPECT_NEAR(thing.SteadyX(), -0.5, 1e-6);
  EXPECT_EQ(thing.track.ToObjectTrack().steadied_over, 5U);
}

// The camera turns by a quarter: x becomes y, and so does what is vague.
TEST(Track, WhatIsVagueStaysSoInSpace) {
  const Eigen::Isometry3f turn(
      Eigen::AngleAxisf(static_cast<float>(EIGEN_PI) / 2, Eigen::Vector3f::UnitZ()));
  for (const bool along : {true, false}) {
    Sighting vague = ThingAt(0);
    vague.uncertainty->pose_covariance(0, 0) = 0.02F * 0.02F;
    Track track(1, vague, std::nullopt);
    track.Advance(turn, 0.1);
    std::swap(vague.uncertainty->pose_covariance(0, 0), vague.uncertainty->pose_covariance(1, 1));
    vague.box.center = vague.centroid =
        along ? Eigen::Vector3f(0, 0.03F, 1) : Eigen::Vector3f(0.03F, 0, 1);
    track.OnSeen(vague, 0, std::nullopt);
    EXPECT_EQ(track.ToObjectTrack().is_moving, !along);
  }
}

// The camera turns upside down twice, while it goes on by 4 cm a frame.
TEST(Track, GoesOnAsFastAsItMovedForHalfASecond) {
  const Eigen::Isometry3f turn(
      Eigen::AngleAxisf(static_cast<float>(EIGEN_PI), Eigen::Vector3f::UnitZ()));
  Followed thing;
  for (int i = 1; i < 8; ++i) thing.See(0.04F * static_cast<float>(i));
  thing.Wait(0.05, turn);
  thing.track.OnMissed();
  for (int i = 0; i < 9; ++i) thing.Wait(0.05);
  const float farthest_m = -thing.track.expected().centroid.x();
  EXPECT_NEAR(farthest_m, 0.28 + 0.5 * 0.4, 0.03);
  thing.Wait(0.5, turn);
  EXPECT_NEAR(thing.track.expected().centroid.x(), farthest_m, 1e-5);
  EXPECT_NEAR(thing.track.expected().box.center.x(), farthest_m, 0.01);
  EXPECT_NEAR(thing.track.expected().points[0].x(), farthest_m, 0.01);
}

TEST(Track, IsExpectedWhereItWasPushedTo) {
  Followed thing;
  thing.See(0.1F);
  thing.Wait(0.1);
  EXPECT_NEAR(thing.track.expected().centroid.x(), 0.1, 1e-5) << "no more is known of its speed";
}

}  // namespace
}  // namespace fovea
