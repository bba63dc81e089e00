#include "core/tracking/tracker.h"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/core/tracking/table_view.h"
#include "tests/core/tracking/track_ids.h"

namespace fovea {
namespace {

using testing::At;
using ::testing::ElementsAre;
using testing::HiddenIds;
using testing::Ids;
using testing::kBlue;
using testing::kRed;
using testing::PosedAt;
using testing::View;

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

// By 25 mm, which is five times what poses err by at one metre.
TEST(Tracker, WhatIsFarIsMovedFartherByWhatPosesErrBy) {
  BoxUncertainty sure;
  sure.pose_covariance.diagonal().setConstant(0.001F * 0.001F);
  sure.size_sigma_m.setConstant(0.001F);
  for (const float z_m : {0.9F, 2.5F}) {
    Tracker tracker(1);
    Detections last;
    for (int i = 0; i < 3; ++i) {
      View view(0.1 * i, i + 1);
      view.Add({i == 2 ? 0.125F : 0.1F, 0, z_m}).detections.objects[0].uncertainty = sure;
      last = view.TrackBy(tracker, PosedAt(0.1 * i));
    }
    EXPECT_EQ(last.objects[0].track->is_moving, z_m < 1) << z_m;
  }
}

// Five of a kind, a decimetre and a bit apart, and a camera that drives past by as much, but for
// the step without a pose, which is as long or 3 cm shorter.
TEST(Tracker, ALostPoseMixesNothingUp) {
  BoxUncertainty sure;
  sure.pose_covariance.diagonal().setConstant(0.001F * 0.001F);
  for (const double shorter_m : {0.0, 0.03}) {
    SCOPED_TRACE(shorter_m);
    Tracker tracker(1);
    for (unsigned i = 0; i < 6; ++i) {
      const bool lost = i == 3, unknown = lost && shorter_m > 0;
      const double x_m = 0.12 * i - (lost ? shorter_m : 0);
      View view(x_m, i + 1);
      for (int k = 0; k < 5; ++k) view.Add({0.12F * static_cast<float>(k), 0, 0.8F}, kRed, 0.08F);
      for (DetectedObject& object : view.detections.objects) object.uncertainty = sure;
      const Detections seen = view.TrackBy(tracker, lost ? FrameContext{} : PosedAt(x_m));
      EXPECT_THAT(Ids(seen), ElementsAre(1, 2, 3, 4, 5)) << i;
      const unsigned before = shorter_m > 0 && i > 3 ? i - 1 : i;
      EXPECT_EQ(seen.objects[4].track->steadied_over, unknown ? 1U : before + 1) << i;
      EXPECT_NEAR(seen.objects[4].track->steadied_box.center.x(), 0.48 - x_m, 0.002) << i;
      EXPECT_EQ(seen.tracking->motion.source == CameraMotionSource::kUnknown, unknown) << i;
      for (const DetectedObject& object : seen.objects) EXPECT_FALSE(object.track->is_moving) << i;
    }
  }
}

// The table is plain: nothing but the things themselves says that the camera stands.
TEST(Tracker, ThingsTellWhatThePictureDoesNot) {
  Tracker tracker(1);
  Detections last;
  for (int i = 0; i < 8; ++i) {
    View view(0, i + 1);
    view.frame.color_rgb.setTo(cv::Scalar::all(200));
    for (const float x_m : {-0.2F, 0.0F, 0.2F}) {
      const bool moves = x_m > 0 && i == 7;
      view.Add({moves ? 0.27F : x_m, 0, 0.8F});
    }
    last = view.TrackBy(tracker);
    EXPECT_EQ(last.tracking->motion.source,
              i == 0 ? CameraMotionSource::kFirstFrame : CameraMotionSource::kEstimated);
  }
  EXPECT_EQ(last.objects[0].track->steadied_over, 8U);
  EXPECT_FALSE(last.objects[0].track->is_moving);
  EXPECT_TRUE(last.objects[2].track->is_moving);
}

// Somewhere else, nobody knows where, the wall is seen where it was.
TEST(Tracker, NothingIsGoneWhereTheCameraIsNotKnown) {
  for (const bool lost : {true, false}) {
    Tracker tracker(1);
    for (int i = 0; i < 2; ++i) View(0, i + 1).Add({0, 0, 0.8F}).TrackBy(tracker, PosedAt(0));
    const Detections after = View(0, 3).TrackBy(tracker, lost ? FrameContext{} : PosedAt(0));
    ASSERT_THAT(HiddenIds(after), ElementsAre(1));
    EXPECT_EQ(after.tracking->hidden[0].reason,
              lost ? HiddenReason::kNotDetected : HiddenReason::kGone);
  }
}

TEST(Tracker, NothingIsGoneOrCoveredWhereNothingIsMeasured) {
  for (const float none : {std::nanf(""), 0.0F, 1e-4F, 2e4F}) {
    Tracker tracker(1);
    for (int i = 0; i < 2; ++i) View(0, i + 1).Add({0, 0, 0.8F}).TrackBy(tracker, PosedAt(0));
    const Detections after =
        View(0, 3).Cover({100, 60, 120, 120}, none).TrackBy(tracker, PosedAt(0));
    ASSERT_THAT(HiddenIds(after), ElementsAre(1));
    EXPECT_EQ(after.tracking->hidden[0].reason, HiddenReason::kNotDetected) << none;
  }
}

// In the place of what the camera saw to be gone; behind something it may have looked otherwise.
TEST(Tracker, WhatWasTakenAwayComesBackInItsColor) {
  for (const bool is_covered : {false, true}) {
    for (const auto& color : {kRed, kBlue}) {
      Tracker tracker(1);
      for (int i = 0; i < 2; ++i) View(0, i + 1).Add({0, 0, 0.8F}).TrackBy(tracker, At(0.1 * i));
      View without(0, 3);
      if (is_covered) without.Cover({100, 60, 120, 120}, 0.4F);
      const Detections hidden = without.TrackBy(tracker, At(0.2));
      ASSERT_THAT(HiddenIds(hidden), ElementsAre(1));
      EXPECT_EQ(hidden.tracking->hidden[0].reason,
                is_covered ? HiddenReason::kCovered : HiddenReason::kGone);
      const Detections after = View(0, 4).Add({0, 0, 0.8F}, color).TrackBy(tracker, At(0.3));
      EXPECT_THAT(Ids(after), ElementsAre(is_covered || color == kRed ? 1 : 2));
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

// It goes behind something from the right on, and comes out at the right.
TEST(Tracker, KnowsThePartThatComesOutFromBehindSomething) {
  Tracker tracker(1);
  View(0, 1).Add({0, 0, 0.8F}, kRed, 0.2F).TrackBy(tracker, At(0));
  View(0, 2).Add({-0.05F, 0, 0.8F}).TrackBy(tracker, At(0.1));
  View(0, 3).Cover({100, 60, 120, 120}, 0.5F).TrackBy(tracker, At(0.2));
  const Detections after = View(0, 4).Add({0.05F, 0, 0.8F}).TrackBy(tracker, At(0.3));
  EXPECT_THAT(Ids(after), ElementsAre(1));
}

TEST(Tracker, LooksForWhatWasThereHoweverLongAgoTheLastFrameIs) {
  Tracker tracker(1);
  View(0, 1).Add({0, 0, 0.8F}).TrackBy(tracker, At(10));
  EXPECT_THAT(Ids(View(0, 2).Add({0, 0, 0.8F}).TrackBy(tracker, At(70))), ElementsAre(1));
}

// Not what was hidden already, or is now: that is longer than two seconds.
TEST(Tracker, ForgetsWhatIsHiddenWhileThereAreNoFrames) {
  for (const bool hidden_before : {true, false}) {
    Tracker tracker(1);
    View(0, 1).Add({0, 0, 0.8F}).TrackBy(tracker, At(10));
    View(0, 2).Add({0, 0, 0.8F}).TrackBy(tracker, At(10.1));
    if (hidden_before) {
      EXPECT_THAT(HiddenIds(View(0, 3).TrackBy(tracker, At(10.2))), ElementsAre(1));
      EXPECT_THAT(Ids(View(0, 4).Add({0, 0, 0.8F}).TrackBy(tracker, At(70))), ElementsAre(2));
    } else {
      EXPECT_THAT(HiddenIds(View(0, 3).TrackBy(tracker, At(70))), ElementsAre());
    }
  }
}

// Of any confidence: what is hard to see is found now and then, and may be a mistake until then.
TEST(Tracker, KnowsWhatIsFoundNowAndThen) {
  for (const float confidence : {0.9F, 0.3F}) {
    Tracker tracker(1);
    for (int i = 0; i < 3; ++i) {
      const auto time = static_cast<double>(i);
      const Detections found =
          View(0, 2 * i + 1).Add({0, 0, 0.8F}, kRed, 0.1F, confidence).TrackBy(tracker, At(time));
      EXPECT_THAT(Ids(found), ElementsAre(1)) << confidence;
      EXPECT_EQ(found.objects[0].track->times_seen, i + 1U);
      const Detections missed = View(0, 2 * i + 2).TrackBy(tracker, At(time + 0.5));
      EXPECT_EQ(HiddenIds(missed).size(), i == 0 ? 0U : 1U) << i;
    }
  }
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
