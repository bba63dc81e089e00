// What speaks for and against a detection being a track, one thing at a time; sums by hand.
#include <gmock/gmock.h>

#include <optional>
#include <utility>
#include <vector>

#include "core/tracking/association.h"

namespace fovea {
namespace {

using ::testing::ElementsAre;

constexpr CameraIntrinsics kLens = {250, 250, 159.5, 119.5};
constexpr float kSize_m = 0.2F;  // of boxes along their diagonal: half of it is 0.1 m

// A thing a metre away of which 25 × 25 pixels are seen.
Sighting Thing(float x_m, float size_m = kSize_m, float lightness = 50) {
  const Eigen::Vector3f center(x_m, 0, 1);
  return {.label = 1,
          .confidence = 0.9F,
          .box = {.center = center, .size_m = {0, 0, size_m}},
          .centroid = center,
          .lab = {lightness, 0, 0},
          .visible_m2 = 0.01F,
          .points = {Eigen::Vector3f(0, 0, 1)}};
}

struct Frame {
  // The mask of label 1: all of the image, or none of it.
  explicit Frame(bool is_covered) : labels(240, 320, CV_16UC1, cv::Scalar(is_covered ? 1 : 0)) {}

  bool Matches(const Track& track, const Sighting& detection) const {
    return Associate({track}, {detection}, {labels, kLens, camera_error_m}).front() == 0;
  }
  bool Matches(const Sighting& detection) const {
    return Matches(Track(1, Thing(0), std::nullopt), detection);
  }

  cv::Mat labels;
  double camera_error_m = 0;
};

const Frame kApart(false), kOver(true);  // the masks

TEST(AssociationCost, IsOfTheDistanceBesideHalfTheSizeWhereNothingOverlaps) {
  EXPECT_TRUE(kApart.Matches(Thing(0.064F))) << "1 + 0.064 / 0.11";
  EXPECT_FALSE(kApart.Matches(Thing(0.068F))) << "1 + 0.068 / 0.11";
  EXPECT_TRUE(kOver.Matches(Thing(0.068F)));
}

TEST(AssociationCost, IsOfTheNearerOfMiddlesAndCentroids) {
  Sighting seen_in_part = Thing(0.08F);
  seen_in_part.box.center.x() = 0.01F;
  EXPECT_TRUE(kApart.Matches(seen_in_part));
  std::swap(seen_in_part.box.center, seen_in_part.centroid);
  EXPECT_TRUE(kApart.Matches(seen_in_part));
}

TEST(AssociationCost, ReachIsHalfTheSizeWhateverOverlaps) {
  EXPECT_TRUE(kOver.Matches(Thing(0.098F)));
  EXPECT_FALSE(kOver.Matches(Thing(0.102F))) << "though it is less than 1";
}

TEST(AssociationCost, ReachGrowsWithTheErrorOfTheCameraAndWhileHidden) {
  Frame off = kOver;
  off.camera_error_m = 0.02;
  EXPECT_TRUE(off.Matches(Thing(0.155F))) << "reach 0.1 + 3 · 0.02";
  EXPECT_FALSE(off.Matches(Thing(0.165F)));
  Track hidden(1, Thing(0), std::nullopt);
  hidden.Advance(Eigen::Isometry3f::Identity(), 0.03);
  EXPECT_TRUE(kOver.Matches(hidden, Thing(0.125F))) << "reach 0.1 + 0.03";
  EXPECT_FALSE(kOver.Matches(hidden, Thing(0.135F)));
}

TEST(AssociationCost, ReachGrowsForHalfASecondOnly) {
  Track large(1, Thing(0, 4), std::nullopt);
  large.OnMissed();
  large.Advance(Eigen::Isometry3f::Identity(), 10);
  EXPECT_TRUE(kOver.Matches(large, Thing(2.45F, 4))) << "reach 2 + 0.5";
  EXPECT_FALSE(kOver.Matches(large, Thing(2.55F, 4)));
}

TEST(AssociationCost, OverlapIsOfBothAndOfTheSmallerOne) {
  const Sighting other_color = Thing(0.088F, kSize_m, 90);
  EXPECT_TRUE(kOver.Matches(other_color)) << "1 - 1 + 0.088 / 0.11 + 0.5";
  Sighting quarter = other_color;
  quarter.visible_m2 /= 4;
  EXPECT_FALSE(kOver.Matches(quarter)) << "1 - (1/4 + 1) / 2 + 0.088 / 0.11 + 0.5";
  quarter.lab.x() = 70;
  EXPECT_TRUE(kOver.Matches(quarter)) << "1 - (1/4 + 1) / 2 + 0.088 / 0.11 + 0.25";
}

// Of what a lens shows nothing, such as behind its border: as of one pixel, all of which is
// covered.
TEST(AssociationCost, OverlapOfAThingWithoutPixelsIsHalf) {
  Sighting none = Thing(0);
  none.visible_m2 = 0;
  const Track track(1, none, std::nullopt);
  EXPECT_TRUE(kOver.Matches(track, Thing(0.064F, kSize_m, 90))) << "1 - 1/2 + 0.064 / 0.11 + 0.5";
  EXPECT_FALSE(kOver.Matches(track, Thing(0.069F, kSize_m, 90))) << "1 - 1/2 + 0.069 / 0.11 + 0.5";
}

TEST(AssociationCost, OverlapIsOfTheShareOfPointsThatTheMaskCovers) {
  Sighting half = Thing(0);
  half.points.emplace_back(5, 0, 1);
  const Track track(1, half, std::nullopt);
  EXPECT_TRUE(kOver.Matches(track, Thing(0.055F, kSize_m, 90))) << "1 - 5/12 + 0.055 / 0.11 + 0.5";
  EXPECT_FALSE(kOver.Matches(track, Thing(0.058F, kSize_m, 90)));
}

TEST(AssociationCost, PointsAreSeenToHalfAPixelBesideTheImage) {
  for (const cv::Point2d& along : {cv::Point2d(1, 0), cv::Point2d(0, 1)}) {
    for (const double off_px : {0.4, 0.6}) {
      const cv::Point2d last = 319 * cv::Point2d(along.x, 0) + 239 * cv::Point2d(0, along.y);
      for (const cv::Point2d& pixel : {-off_px * along, last + off_px * along}) {
        Sighting beside = Thing(0);
        beside.points = {{static_cast<float>((pixel.x - kLens.cx_px) / kLens.fx_px),
                          static_cast<float>((pixel.y - kLens.cy_px) / kLens.fy_px), 1}};
        EXPECT_EQ(kOver.Matches(Track(1, beside, std::nullopt), Thing(0.068F)), off_px < 0.5)
            << pixel;
      }
    }
  }
}

TEST(AssociationCost, PointsBehindTheCameraAreNotSeen) {
  Sighting behind = Thing(0);
  behind.points = {{0, 0, -1}};
  EXPECT_FALSE(kOver.Matches(Track(1, behind, std::nullopt), Thing(0.068F)));
}

TEST(AssociationCost, AColorCountsHalfAtMost) {
  EXPECT_TRUE(kApart.Matches(Thing(0.03F, kSize_m, 70))) << "1 + 0.03 / 0.11 + 0.25";
  EXPECT_FALSE(kApart.Matches(Thing(0.03F, kSize_m, 80))) << "1 + 0.03 / 0.11 + 0.375";
  EXPECT_TRUE(kOver.Matches(Thing(0.088F, kSize_m, 250))) << "1 - 1 + 0.088 / 0.11 + 0.5";
}

// Sizes are compared with a centimetre more.
TEST(AssociationCost, ASizeCountsHalfAtFourTimesOrAQuarter) {
  EXPECT_TRUE(kApart.Matches(Thing(0.055F, 0.41F))) << "1 + 0.055 / 0.1625 + 0.25";
  EXPECT_FALSE(kApart.Matches(Thing(0.06F, 0.41F))) << "1 + 0.06 / 0.1625 + 0.25";
  EXPECT_TRUE(kApart.Matches(Thing(0.028F, 0.095F))) << "1 + 0.028 / 0.08375 + 0.25";
  EXPECT_FALSE(kApart.Matches(Thing(0.031F, 0.095F))) << "1 + 0.031 / 0.08375 + 0.25";
  EXPECT_TRUE(kApart.Matches(Thing(0.08F, 3.35F))) << "1 + 0.08 / 0.8975 + 0.5, for 16 times";
}

// The second detection is nearer to the first track than the first one, which is within reach of
// the second track but too unlike it: how much so does not count.
TEST(AssociationCost, MoreThanTheMostDoesNotCount) {
  const std::vector<Track> tracks{Track(1, Thing(0), std::nullopt),
                                  Track(2, Thing(-0.12F, kSize_m, 90), std::nullopt)};
  EXPECT_THAT(Associate(tracks, {Thing(-0.03F), Thing(0.02F)}, {kApart.labels, kLens, 0}),
              ElementsAre(-1, 0));
}

}  // namespace
}  // namespace fovea
