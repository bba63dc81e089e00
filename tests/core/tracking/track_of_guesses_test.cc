// A track where the camera's motion is not known.
#include <gtest/gtest.h>

#include <optional>

#include "core/tracking/track.h"
#include "tests/core/tracking/followed_thing.h"

namespace fovea {
namespace {

using testing::Followed;
using testing::kStands;
using testing::ThingAt;

// Of a frame with an unknown place: it was guessed 5 cm beside where the camera is.
const Eigen::Isometry3f kWrong(Eigen::Translation3f(0.05F, 0, 0));

TEST(Track, WhatIsSeenByGuessIsNotInTheMeanThatGoesOnLater) {
  Followed thing;
  for (unsigned i = 0; i < 3; ++i) {
    thing.Wait(0.1, i == 0 ? kWrong : kStands);
    const ObjectTrack seen = thing.SeeIn(1 + i, ThingAt(0));
    EXPECT_FLOAT_EQ(seen.steadied_box.center.x(), 0) << "as it is seen";
    EXPECT_EQ(seen.steadied_over, 1U);
    EXPECT_EQ(seen.times_seen, 5U + i);
    EXPECT_FALSE(thing.track.HasMeanOf(1 + i));
  }
  thing.Wait(0.1, kWrong.inverse());
  thing.track.Enter(0);
  EXPECT_NEAR(thing.track.expected().box.center.x(), 0, 1e-6);
  const ObjectTrack after = thing.SeeIn(0, ThingAt(0.001F));
  EXPECT_FALSE(after.is_moving);
  EXPECT_EQ(after.steadied_over, 5U);
  EXPECT_NEAR(after.steadied_box.center.x(), 0.0002, 1e-6);
}

// The frames after it tell where the camera went from there, not where that is.
TEST(Track, BeginsAnewWhereTheGuessStays) {
  for (const bool seen : {true, false}) {
    Followed thing;
    thing.Wait(0.1, kWrong);
    if (seen) thing.SeeIn(1, ThingAt(0));
    thing.Wait(0.1);
    const ObjectTrack after = thing.SeeIn(1, ThingAt(0.001F));
    EXPECT_FALSE(after.is_moving) << seen;
    EXPECT_EQ(after.steadied_over, seen ? 2U : 1U);
    EXPECT_NEAR(after.steadied_box.center.x(), seen ? 0.0005 : 0.001, 1e-6);
    EXPECT_EQ(thing.SeeIn(1, ThingAt(0.001F)).steadied_over, seen ? 3U : 2U);
  }
}

// The second guess is wrong, too, and the first frame that is known beside it showed it not.
TEST(Track, BeginsAnewAfterGuessesInARowToo) {
  Followed thing;
  thing.Wait(0.1, kWrong);
  thing.SeeIn(1, ThingAt(0));
  thing.Wait(0.1, kWrong);
  thing.track.OnMissed();
  thing.Wait(0.1);
  thing.track.Enter(2);
  EXPECT_FALSE(thing.track.IsOf(2));
  for (const unsigned over : {1U, 2U, 3U}) {
    const ObjectTrack after = thing.SeeIn(2, ThingAt(0));
    EXPECT_FALSE(after.is_moving) << over;
    EXPECT_EQ(after.steadied_over, over);
    EXPECT_NEAR(after.steadied_box.center.x(), 0, 1e-6);
  }
}

TEST(Track, BeginsAnewWhereItIsNewByGuess) {
  Track track(1, ThingAt(0), std::nullopt, 1);
  track.Advance(kWrong, 0.1);
  track.Enter(0);
  track.OnSeen(ThingAt(0), 0, std::nullopt, 0);
  EXPECT_FALSE(track.ToObjectTrack().is_moving);
  EXPECT_NEAR(track.ToObjectTrack().steadied_box.center.x(), 0, 1e-6);
}

}  // namespace
}  // namespace fovea
