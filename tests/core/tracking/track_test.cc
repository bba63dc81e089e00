#include "core/tracking/track.h"

#include <gtest/gtest.h>

#include <optional>
#include <utility>

namespace fovea {
namespace {

// Half a metre along its diagonal, a metre away: stands within 0.015 + 0.2 · 0.5 = 0.115 m.
Sighting ThingAt(float x_m) {
  const Eigen::Vector3f center(x_m, 0, 1);
  return {
      .box = {.center = center, .size_m = {0.3F, 0, 0.4F}}, .centroid = center, .points = {center}};
}

const Eigen::Isometry3f kStands = Eigen::Isometry3f::Identity();

struct Followed {
  // It has stood at 0 for so long that its steady place moves by a tenth of what it is off.
  Followed() {
    for (int i = 0; i < 9; ++i) See(0);
  }

  void Wait(double seconds, const Eigen::Isometry3f& this_from_last = kStands) {
    track.Advance(this_from_last, seconds);
  }
  bool See(float x_m, double camera_error_m = 0, double seconds = 0.1,
           const Eigen::Isometry3f& this_from_last = kStands) {
    Wait(seconds, this_from_last);
    track.OnSeen(ThingAt(x_m), camera_error_m, std::nullopt);
    return track.ToObjectTrack().is_moving;
  }

  Track track{1, ThingAt(0), std::nullopt};
};

TEST(Track, MovesWhereItIsOffItsPlaceTwice) {
  Followed off_once, noisy, moved, unsure, to_and_fro;
  EXPECT_FALSE(off_once.See(0.15F)) << "0.9 · 0.15 = 0.135";
  EXPECT_FALSE(off_once.See(0));
  EXPECT_FALSE(off_once.See(0.15F));
  noisy.See(0.14F);
  EXPECT_FALSE(noisy.See(0.14F)) << "0.9² · 0.14 = 0.113";
  moved.See(0.15F);
  EXPECT_TRUE(moved.See(0.15F)) << "0.9² · 0.15 = 0.122";
  unsure.See(0.15F, 0.01);
  EXPECT_FALSE(unsure.See(0.15F, 0.01)) << "3 · 0.01 of the camera's";
  to_and_fro.See(0.15F);
  EXPECT_FALSE(to_and_fro.See(-0.2F)) << "mistakes of the mask";
}

// Its centroid and its middle are each where the other one is wrong: off by 0.9² · 0.14 = 0.113.
TEST(Track, StandsWhereAnotherPartOfItIsSeen) {
  for (const bool by_centroid : {true, false}) {
    Followed thing;
    thing.Wait(0, Eigen::Isometry3f(Eigen::Translation3f(-0.5F, 0, 0)));
    Sighting in_part = ThingAt(-0.36F);
    (by_centroid ? in_part.centroid : in_part.box.center).x() = -0.2F;
    for (int i = 0; i < 2; ++i) {
      thing.Wait(0.1);
      thing.track.OnSeen(in_part, 0, std::nullopt);
    }
    EXPECT_FALSE(thing.track.ToObjectTrack().is_moving);
  }
}

TEST(Track, StandsWhereOnlyTheCameraMoves) {
  Followed thing;
  EXPECT_FALSE(thing.See(-0.5F, 0, 0.1, Eigen::Isometry3f(Eigen::Translation3f(-0.5F, 0, 0))));
  EXPECT_NEAR(thing.track.ToObjectTrack().steadied_box.center.x(), -0.5, 1e-6);
  EXPECT_EQ(thing.track.ToObjectTrack().steadied_over, 10U);
}

// Its steady place is at 0.015 after the first of two sightings, and at 0.0385 after the second: it
// is off by 0.135 and 0.2115. The camera turns upside down twice.
TEST(Track, GoesOnAsFastAsItMoved) {
  const Eigen::Isometry3f turn(
      Eigen::AngleAxisf(static_cast<float>(EIGEN_PI), Eigen::Vector3f::UnitZ()));
  Followed thing;
  thing.See(0.15F);
  EXPECT_TRUE(thing.See(-0.25F, 0, 0.2, turn));
  EXPECT_NEAR(thing.track.ToObjectTrack().steadied_box.center.x(), -0.25, 1e-6);
  EXPECT_EQ(thing.track.ToObjectTrack().steadied_over, 1U);
  const double velocity = (0.2115 - 0.135) / 0.2;
  thing.Wait(0.25, turn);
  EXPECT_NEAR(thing.track.expected().centroid.x(), 0.25 + 0.25 * velocity, 1e-5);
  thing.track.OnMissed();
  for (int i = 0; i < 3; ++i) thing.Wait(0.25);
  const Sighting& expected = thing.track.expected();
  for (const Eigen::Vector3f& place :
       {expected.centroid, expected.box.center, expected.points[0]}) {
    EXPECT_NEAR(place.x(), 0.25 + 0.5 * velocity, 1e-5) << "half a second, and no farther";
  }
}

// At 0.165 it is as far off as before: 0.9 · (0.165 - 0.015) = 0.135. A tenth of a second later the
// variance of its place is 0.02² + (0.5 / 10)² + (3 / 200)² = 0.003125, of place and speed 0.0295,
// so that of two centimetres ahead 0.0295 / (0.003125 + 0.055²) as much is taken for speed.
TEST(Track, BelievesLessWhereTheCamerasMotionIsUnsure) {
  for (const auto& [camera_error_m, gain] : {std::pair(0.0, 4.797), std::pair(0.05, 2.085)}) {
    Followed thing;
    thing.See(0.15F);
    EXPECT_TRUE(thing.See(0.165F));
    thing.See(0.185F, camera_error_m);
    thing.Wait(0.1);
    EXPECT_NEAR(thing.track.expected().centroid.x(), 0.185 + 0.1 * 0.02 * gain, 1e-5);
  }
}

// How many frames it takes until a thing that was moved to `x_m` stands there.
int FramesUntilItStands(Followed& thing, float x_m, double seconds = 0.1) {
  thing.See(x_m, 0, seconds);
  EXPECT_TRUE(thing.See(x_m, 0, seconds));
  int frames = 1;
  while (frames < 100 && thing.See(x_m, 0, seconds)) ++frames;
  return frames;
}

TEST(Track, StandsWhereItStopped) {
  Followed thing;
  EXPECT_GE(FramesUntilItStands(thing, 0.15F), 5);
  EXPECT_FALSE(thing.See(0.45F)) << "once may be a mistake again";
  for (int i = 0; i < 30; ++i) thing.See(0.15F);
  EXPECT_EQ(thing.track.ToObjectTrack().steadied_over, 10U);
  EXPECT_NEAR(thing.track.ToObjectTrack().steadied_box.center.x(), 0.15, 0.01);
  thing.See(0.3F);
  EXPECT_TRUE(thing.See(0.315F));
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(thing.See(0.315F)) << "slow for " << i + 1;
}

TEST(Track, StandsWhereItStoppedHoweverFewTheFrames) {
  Followed thing;
  thing.See(0.15F, 0, 1);
  EXPECT_TRUE(thing.See(0.4F, 0, 1));
  EXPECT_TRUE(thing.See(0.65F, 0, 1));
  EXPECT_LE(FramesUntilItStands(thing, 0.65F, 1), 5);
}

TEST(Track, GoesOnAsFastAsAHandAtMost) {
  Followed thing;
  thing.See(0.15F);
  EXPECT_TRUE(thing.See(0.35F, 0, 0.001)) << "(0.9 · 0.335 - 0.135) m in a millisecond";
  thing.Wait(0.1);
  EXPECT_NEAR(thing.track.expected().centroid.x(), 0.35 + 0.1 * 1, 1e-5);
}

TEST(Track, StandsWhereItStoppedThoughAnotherPartOfItIsSeen) {
  Followed thing;
  for (const float x_m : {0.15F, 0.3F, 0.45F, 0.6F}) thing.See(x_m);
  FramesUntilItStands(thing, 0.75F);
  Sighting in_part = ThingAt(0.75F);
  in_part.box.center.x() = 1.5F;
  for (int i = 0; i < 2; ++i) thing.track.OnSeen(in_part, 0, std::nullopt);
  EXPECT_FALSE(thing.track.ToObjectTrack().is_moving);
}

// It seems to be as slow as noise for the last four of nine frames.
TEST(Track, MovesThoughItPauses) {
  Followed thing;
  thing.See(0.15F);
  EXPECT_TRUE(thing.See(0.165F));
  for (int i = 2; i < 6; ++i) {
    for (int frame = 0; frame < 9; ++frame) {
      EXPECT_TRUE(thing.See(0.15F * static_cast<float>(i))) << i << ' ' << frame;
    }
  }
}

}  // namespace
}  // namespace fovea
