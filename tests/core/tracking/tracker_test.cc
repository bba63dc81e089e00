#include "core/tracking/tracker.h"

#include <gmock/gmock.h>

#include <limits>
#include <optional>

#include "tests/core/tracking/table_view.h"

namespace fovea {
namespace {

using testing::At;
using ::testing::ElementsAre;
using testing::kBlue;
using testing::kRed;
using testing::PosedAt;
using testing::View;

std::vector<std::uint64_t> Ids(const Detections& detections) {
  std::vector<std::uint64_t> ids;
  for (const DetectedObject& object : detections.objects) ids.push_back(object.track->id);
  return ids;
}

std::vector<std::uint64_t> HiddenIds(const Detections& detections) {
  std::vector<std::uint64_t> ids;
  for (const HiddenTrack& track : detections.tracking->hidden) ids.push_back(track.id);
  return ids;
}

TEST(Tracker, KeepsIdsWhateverTheOrder) {
  Tracker tracker(9);
  const Detections first =
      View(0, 1).Add({-0.1F, 0, 0.8F}, kRed).Add({0.1F, 0, 0.8F}, kBlue).TrackBy(tracker, At(5));
  EXPECT_THAT(Ids(first), ElementsAre(1, 2));
  EXPECT_EQ(first.tracking->epoch, 9U);
  EXPECT_EQ(first.objects[0].track->times_seen, 1U);
  const Detections next =
      View(0, 2).Add({0.1F, 0, 0.8F}, kBlue).Add({-0.1F, 0, 0.8F}, kRed).TrackBy(tracker, At(5.5));
  EXPECT_THAT(Ids(next), ElementsAre(2, 1));
  EXPECT_EQ(next.objects[0].track->times_seen, 2U);
  EXPECT_EQ(next.objects[0].track->steadied_over, 2U);
  EXPECT_EQ(next.objects[0].track->first_seen, (CaptureTime{5, 0}));
  EXPECT_EQ(next.tracking->motion.source, CameraMotionSource::kStanding);
}

// The camera moves by as much as the things are apart: in the image each is where its neighbour
// was.
TEST(Tracker, TakesTheCamerasMotionOut) {
  for (const bool posed : {true, false}) {
    SCOPED_TRACE(posed);
    Tracker tracker(1);
    for (const double x_m : {0.0, 0.12, 0.24}) {
      View view(x_m, 1);
      view.Add({-0.2F, 0, 0.8F}).Add({-0.08F, 0, 0.8F}).Add({0.04F, 0, 0.8F}).Add({0.16F, 0, 0.8F});
      EXPECT_THAT(Ids(view.TrackBy(tracker, posed ? PosedAt(x_m) : FrameContext{})),
                  ElementsAre(1, 2, 3, 4))
          << x_m;
    }
  }
}

TEST(Tracker, KeepsWhatIsHiddenForTwoSeconds) {
  for (const double hidden_s : {1.5, 2.5}) {
    Tracker tracker(1);
    double time = 0;
    const auto see = [&](bool covered) {
      View view(0, static_cast<std::uint64_t>(time * 10) + 1);
      if (covered) view.Cover({100, 60, 120, 120}, 0.5F);
      if (!covered) view.Add({0, 0, 0.8F});
      Detections result = view.TrackBy(tracker, At(time));
      time += 0.25;
      return result;
    };
    see(false);
    see(false);
    const Detections covered = see(true);
    ASSERT_THAT(HiddenIds(covered), ElementsAre(1));
    EXPECT_EQ(covered.tracking->hidden[0].reason, HiddenReason::kCovered);
    EXPECT_EQ(covered.tracking->hidden[0].last_seen, (CaptureTime{0, 250'000'000}));
    EXPECT_EQ(covered.tracking->hidden[0].times_seen, 2U);
    EXPECT_NEAR(covered.tracking->hidden[0].box.center.z(), 0.8, 1e-5);
    while (time < 0.25 + hidden_s) see(true);
    EXPECT_THAT(Ids(see(false)), ElementsAre(hidden_s < 2 ? 1 : 2)) << hidden_s;
  }
}

TEST(Tracker, LooksForWhatWasThereHoweverLongAgoTheLastFrameIs) {
  Tracker tracker(1);
  View(0, 1).Add({0, 0, 0.8F}).TrackBy(tracker, At(10));
  EXPECT_THAT(Ids(View(0, 2).Add({0, 0, 0.8F}).TrackBy(tracker, At(70))), ElementsAre(1));
}

TEST(Tracker, ForgetsWhatWasSeenOnce) {
  Tracker tracker(1);
  View(0, 1).Add({0, 0, 0.8F}).TrackBy(tracker);
  EXPECT_THAT(HiddenIds(View(0, 2).TrackBy(tracker)), ElementsAre());
  EXPECT_THAT(Ids(View(0, 3).Add({0, 0, 0.8F}).TrackBy(tracker)), ElementsAre(2));
}

TEST(Tracker, FollowsWhatAHandMoves) {
  Tracker tracker(1);
  Detections last;
  for (int i = 0; i < 12; ++i) {
    const float x = -0.2F + 0.04F * static_cast<float>(i);
    last = View(0, i + 1)
               .Add({x, 0, 0.7F}, kRed)
               .Add({0, 0.1F, 0.8F}, kRed)
               .TrackBy(tracker, At(0.1 * i));
    EXPECT_THAT(Ids(last), ElementsAre(1, 2)) << i;
  }
  EXPECT_TRUE(last.objects[0].track->is_moving);
  EXPECT_EQ(last.objects[0].track->steadied_over, 1U);
  EXPECT_FALSE(last.objects[1].track->is_moving);
  EXPECT_EQ(last.objects[1].track->steadied_over, 10U);
}

// Half a metre along its diagonal, a metre away: stands within 0.015 + 0.2 · 0.5 = 0.115 m.
Sighting ThingAt(float x_m) {
  const Eigen::Vector3f center(x_m, 0, 1);
  return {
      .box = {.center = center, .size_m = {0.3F, 0, 0.4F}}, .centroid = center, .points = {center}};
}

struct Followed {
  // It has stood at 0 for so long that its steady place moves by a tenth of what it is off.
  Followed() {
    for (int i = 0; i < 9; ++i) See(0);
  }

  void Wait(double seconds, const Eigen::Isometry3f& this_from_last) {
    track.Advance(this_from_last, seconds);
  }
  bool See(float x_m, double camera_error_m = 0, double seconds = 0.1,
           const Eigen::Isometry3f& this_from_last = Eigen::Isometry3f::Identity()) {
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
  const Eigen::Isometry3f stands = Eigen::Isometry3f::Identity();
  for (int i = 0; i < 3; ++i) thing.Wait(0.25, stands);
  const Sighting& expected = thing.track.expected();
  for (const Eigen::Vector3f& place :
       {expected.centroid, expected.box.center, expected.points[0]}) {
    EXPECT_NEAR(place.x(), 0.25 + 0.5 * velocity, 1e-5) << "half a second, and no farther";
  }
}

TEST(Track, StandsWhereItStopped) {
  Followed thing;
  thing.See(0.15F);
  EXPECT_TRUE(thing.See(0.15F));
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(thing.See(0.15F)) << i;
  for (int i = 0; i < 16; ++i) thing.See(0.15F);
  const ObjectTrack stopped = thing.track.ToObjectTrack();
  EXPECT_FALSE(stopped.is_moving);
  EXPECT_GT(stopped.steadied_over, 5U);
  EXPECT_NEAR(stopped.steadied_box.center.x(), 0.15, 1e-6);
  EXPECT_FALSE(thing.See(0.35F)) << "once may be a mistake again";
  EXPECT_TRUE(thing.See(0.35F));
}

TEST(Tracker, BearsHostileTimes) {
  constexpr std::int64_t kYear1 = -62135596800, kYear9999 = 253402300799;
  Tracker tracker(1);
  std::uint64_t seed = 0;
  for (const CaptureTime time : {CaptureTime{kYear9999, 999'999'999}, CaptureTime{kYear1, 0},
                                 CaptureTime{kYear1, 0}, CaptureTime{kYear9999, 0}}) {
    FrameContext context;
    context.captured_at = time;
    EXPECT_THAT(Ids(View(0, ++seed).Add({0, 0, 0.8F}).TrackBy(tracker, context)), ElementsAre(1));
  }
  // As the time stands still, frames count: two seconds of them.
  FrameContext context;
  context.captured_at = CaptureTime{kYear1, 0};
  for (int i = 0; i < 20; ++i) {
    EXPECT_THAT(HiddenIds(View(0, ++seed).TrackBy(tracker, context)), ElementsAre(1)) << i;
  }
  EXPECT_THAT(HiddenIds(View(0, ++seed).TrackBy(tracker, context)), ElementsAre());
}

TEST(Tracker, IsBounded) {
  Tracker tracker(1);
  for (int i = 0; i < 4; ++i) {
    View view(0, i + 1);
    const int layer = i / 2;
    for (int k = 0; k < 200; ++k) {
      const int row = k / 20, col = k % 20;
      view.Add({0.03F * static_cast<float>(col) - 0.3F, 0.05F * static_cast<float>(row) - 0.25F,
                0.8F + 0.02F * static_cast<float>(layer)},
               kRed, 0.02F);
    }
    const Detections result = view.TrackBy(tracker);
    for (int k = 0; k < 200; ++k) {
      EXPECT_EQ(result.objects[k].track.has_value(), k < static_cast<int>(Tracker::kMaxTracks));
    }
    EXPECT_LE(result.tracking->hidden.size(), Tracker::kMaxTracks);
  }
}

TEST(Tracker, IsTheSameEachTime) {
  const auto run = [] {
    Tracker tracker(1);
    Detections last;
    for (int i = 0; i < 6; ++i) {
      last =
          View(0.03 * i, i + 1).Add({-0.1F, 0, 0.8F}).Add({0.1F, 0.01F * i, 0.7F}).TrackBy(tracker);
    }
    return last;
  };
  const Detections a = run(), b = run();
  EXPECT_EQ(a.tracking->motion.last_from_this.matrix(), b.tracking->motion.last_from_this.matrix());
  EXPECT_EQ(a.objects[1].track->steadied_box.center, b.objects[1].track->steadied_box.center);
  EXPECT_EQ(a.objects[1].track->steadied_box.rotation, b.objects[1].track->steadied_box.rotation);
}

}  // namespace
}  // namespace fovea
