#include "core/tracking/association.h"

#include <gmock/gmock.h>

#include <cmath>

#include "core/tracking/hidden.h"
#include "tests/core/tracking/table_view.h"

namespace fovea {
namespace {

using ::testing::ElementsAre;
using testing::kBlue;
using testing::kRed;
using testing::View;

std::vector<Track> TracksOf(const View& view) {
  std::vector<Track> tracks;
  for (const Sighting& each : SightingsOf(view.detections, view.frame.intrinsics, 100)) {
    tracks.emplace_back(tracks.size() + 1, each, std::nullopt);
  }
  return tracks;
}

std::vector<int> AssociateNext(const std::vector<Track>& tracks, const View& view) {
  return Associate(tracks, SightingsOf(view.detections, view.frame.intrinsics, 100),
                   {view.detections.labels, view.frame.intrinsics, 0.0});
}

TEST(Associate, ByPlace) {
  View first, next;
  first.Add({-0.1F, 0, 0.8F}).Add({0.1F, 0, 0.8F});
  next.Add({0.11F, 0, 0.8F}).Add({-0.1F, 0.02F, 0.8F});
  EXPECT_THAT(AssociateNext(TracksOf(first), next), ElementsAre(1, 0));
}

// Halfway to where the other one was: what is nearer alone would swap them or leave it to chance.
TEST(Associate, ByColorWhereThePlaceDoesNotTell) {
  View first, next;
  first.Add({-0.03F, 0, 0.8F}, kRed).Add({0.08F, 0, 0.8F}, kBlue);
  next.Add({0.025F, 0, 0.8F}, kBlue);
  EXPECT_THAT(AssociateNext(TracksOf(first), next), ElementsAre(1));
  View red;
  red.Add({0.025F, 0, 0.8F}, kRed);
  EXPECT_THAT(AssociateNext(TracksOf(first), red), ElementsAre(0));
}

TEST(Associate, NothingBeyondReach) {
  View first, next;
  first.Add({-0.1F, 0, 0.8F});
  next.Add({0.1F, 0, 0.8F});
  EXPECT_THAT(AssociateNext(TracksOf(first), next), ElementsAre(-1));
  EXPECT_THAT(AssociateNext({}, next), ElementsAre(-1));
  EXPECT_THAT(AssociateNext(TracksOf(first), View()), ElementsAre());
}

TEST(Associate, OneThingIsOneTrack) {
  View first, next;
  first.Add({0, 0, 0.8F}).Add({0.04F, 0, 0.8F});
  next.Add({0, 0, 0.8F});
  EXPECT_THAT(AssociateNext(TracksOf(first), next), ElementsAre(0));
}

// The unlikely one lies nearer to where the thing was.
TEST(Associate, ConfidentDetectionsComeFirst) {
  View first, next;
  first.Add({0, 0, 0.8F});
  next.Add({0.03F, 0, 0.8F}, kRed, 0.1F, 0.9F).Add({0, 0.01F, 0.79F}, kRed, 0.1F, 0.3F);
  EXPECT_THAT(AssociateNext(TracksOf(first), next), ElementsAre(0, -1));
  View unlikely_only;
  unlikely_only.Add({0, 0.01F, 0.8F}, kRed, 0.1F, 0.3F);
  EXPECT_THAT(AssociateNext(TracksOf(first), unlikely_only), ElementsAre(0));
}

// 25 pixels wide and high at 2 m; a red of sRGB is (53, 80, 67) in CIELAB.
TEST(SightingsOf, AreWhatIsSeenInMetresAndCielab) {
  View view;
  view.Add({0, 0, 2}, {255, 0, 0}, 0.2F);
  const Sighting sighting = SightingsOf(view.detections, view.frame.intrinsics, 1).front();
  EXPECT_FLOAT_EQ(sighting.visible_m2, 0.04F);
  EXPECT_LT((sighting.lab - Eigen::Vector3f(53, 80, 67)).norm(), 1.5F);
  EXPECT_LE(sighting.points.size(), kMaxSightingPoints);
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  for (const auto& p : sighting.points) mean += p / static_cast<float>(sighting.points.size());
  EXPECT_LT((mean - sighting.centroid).norm(), 0.01F);
}

TEST(SightingsOf, AThingWithoutDepthIsAtItsCentroid) {
  View view;
  view.Add({0.1F, 0, 0.8F});
  view.detections.objects.front().cloud.clear();
  const Sighting sighting = SightingsOf(view.detections, view.frame.intrinsics, 1).front();
  EXPECT_THAT(sighting.points, ElementsAre(Eigen::Vector3f(0.1F, 0, 0.8F)));
}

TEST(Moved, TurnsABox) {
  const Eigen::Isometry3f turn(Eigen::AngleAxisf(1, Eigen::Vector3f::UnitY()));
  const OrientedBox moved = Moved(OrientedBox{.center = {0, 0, 2}}, turn);
  EXPECT_LT((moved.center - 2 * Eigen::Vector3f(std::sin(1.0F), 0, std::cos(1.0F))).norm(), 1e-6F);
  EXPECT_TRUE(moved.rotation.isApprox(turn.linear()));
}

TEST(ReasonOf, TellsWhyAThingIsNotSeen) {
  View with;
  with.Add({0, 0, 0.8F});
  const Sighting expected = SightingsOf(with.detections, with.frame.intrinsics, 1).front();
  EXPECT_EQ(ReasonOf(expected, with.frame), HiddenReason::kNotDetected);
  EXPECT_EQ(ReasonOf(expected, View().frame), HiddenReason::kGone);
  EXPECT_EQ(ReasonOf(expected, View().Cover({100, 60, 120, 120}, 0.5F).frame),
            HiddenReason::kCovered);
  View unmeasured;
  unmeasured.Cover({100, 60, 120, 120}, std::nanf(""));
  EXPECT_EQ(ReasonOf(expected, unmeasured.frame), HiddenReason::kNotDetected);
  // What holds for less than half of it is not why, nor what depth may be wrong by.
  for (const float depth_m : {0.5F, 1.5F}) {
    View in_part;
    in_part.Add({0, 0, 0.8F}).Cover({100, 60, 52, 120}, depth_m);
    EXPECT_EQ(ReasonOf(expected, in_part.frame), HiddenReason::kNotDetected) << depth_m;
  }
  for (const float off_m : {-0.02F, 0.02F}) {
    const auto off = Moved(expected, Eigen::Isometry3f(Eigen::Translation3f(0, 0, off_m)));
    EXPECT_EQ(ReasonOf(off, with.frame), HiddenReason::kNotDetected);
  }
  const auto beside = Moved(expected, Eigen::Isometry3f(Eigen::Translation3f(1, 0, 0)));
  EXPECT_EQ(ReasonOf(beside, with.frame), HiddenReason::kOutOfView);
  const auto at_the_border = Moved(expected, Eigen::Isometry3f(Eigen::Translation3f(0.485F, 0, 0)));
  EXPECT_EQ(ReasonOf(at_the_border, View().frame), HiddenReason::kGone) << "a quarter is outside";
  Sighting in_last_pixel = expected;
  for (const float off_px : {0.4F, 0.6F}) {
    const float x = (159.5F + off_px) / 250, y = (119.5F + off_px) / 250;
    for (const Eigen::Vector3f& point : {Eigen::Vector3f(-x, 0, 1), Eigen::Vector3f(x, 0, 1),
                                         Eigen::Vector3f(0, -y, 1), Eigen::Vector3f(0, y, 1)}) {
      in_last_pixel.points = {point};
      EXPECT_EQ(ReasonOf(in_last_pixel, View().frame) == HiddenReason::kOutOfView, off_px > 0.5F);
    }
  }
  const auto behind = Moved(expected, Eigen::Isometry3f(Eigen::Translation3f(0, 0, -2)));
  EXPECT_EQ(ReasonOf(behind, with.frame), HiddenReason::kOutOfView);
}

}  // namespace
}  // namespace fovea
