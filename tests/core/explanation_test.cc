#include "core/explanation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fovea {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// A detection at which nothing is unusual.
Detections Usual() {
  Detections detections;
  detections.objects.resize(3);
  detections.support = SupportSurface{};
  Diagnostics& d = detections.diagnostics;
  d.num_pixels = 1000;
  d.num_measured = 800;
  d.num_points = 700;
  d.seeds_from_color = 6;
  d.seeds_from_depth = 4;
  d.num_seeds = 5;
  d.num_segments = 8;
  d.num_merged = 3;
  return detections;
}

TEST(ExplainLosses, SaysNothingWhereNothingIsUnusual) {
  EXPECT_THAT(ExplainLosses(Usual()), IsEmpty());
}

TEST(ExplainLosses, NothingMeasuredExplainsAllElse) {
  Detections detections;
  detections.diagnostics.num_pixels = 1000;
  EXPECT_THAT(ExplainLosses(detections), ElementsAre(HasSubstr("no pixel has depth")));
}

TEST(ExplainLosses, AllTooFarExplainsAllElse) {
  Detections detections;
  detections.diagnostics.num_pixels = 1000;
  detections.diagnostics.num_measured = 800;
  detections.diagnostics.num_too_far = 800;
  EXPECT_THAT(
      ExplainLosses(detections),
      ElementsAre(AllOf(HasSubstr("every measured depth is beyond"), HasSubstr("or raise it"))));
}

TEST(ExplainLosses, MostlyTooFarIsNotCalledUnmeasured) {
  Detections detections = Usual();
  detections.diagnostics.num_points = detections.diagnostics.num_measured / 2 - 1;
  detections.diagnostics.num_too_far = detections.diagnostics.num_measured / 2 + 1;
  EXPECT_THAT(ExplainLosses(detections), ElementsAre(HasSubstr("is beyond max_depth_m: raise")));
}

TEST(ExplainLosses, WhatIsLeftOutAsNoiseIsNotCalledTooFar) {
  Detections detections = Usual();
  detections.diagnostics.num_points = detections.diagnostics.num_measured / 2 - 1;
  detections.diagnostics.num_too_far = detections.diagnostics.num_measured / 2 - 1;
  EXPECT_THAT(ExplainLosses(detections), ElementsAre(HasSubstr("mostly noise")));
  detections.diagnostics.num_points = 0;
  EXPECT_THAT(ExplainLosses(detections), ElementsAre(HasSubstr("mostly noise")));
}

TEST(ExplainLosses, WhereNothingIsASeedTheRegionIsNamed) {
  Detections detections = Usual();
  detections.diagnostics.num_seeds = 0;
  EXPECT_THAT(ExplainLosses(detections), ElementsAre(Not(HasSubstr("region"))));
  EXPECT_THAT(ExplainLosses(detections, {.region = true}),
              ElementsAre(HasSubstr("outside of region.*")));
  detections.diagnostics.seeds_from_color = 0;
  detections.diagnostics.seeds_from_depth = 0;
  EXPECT_THAT(ExplainLosses(detections), ElementsAre(Not(HasSubstr("region"))));
  EXPECT_THAT(ExplainLosses(detections, {.region = true}),
              ElementsAre(HasSubstr("within region.*")));
}

TEST(ExplainLosses, SeedsMayComeFromElsewhere) {
  Detections detections = Usual();
  detections.diagnostics.seeds_from_color = 0;
  detections.diagnostics.seeds_from_depth = 0;
  EXPECT_THAT(ExplainLosses(detections), IsEmpty());
}

TEST(ExplainLosses, LittleDepthIsGivenInPercent) {
  Detections detections = Usual();
  detections.diagnostics.num_measured = 123;
  EXPECT_THAT(ExplainLosses(detections), ElementsAre("only 12.3 % of the pixels have depth"));
  detections.diagnostics.num_measured = 200;
  EXPECT_THAT(ExplainLosses(detections), IsEmpty());
}

TEST(ExplainLosses, ABlankColorImage) {
  Detections detections = Usual();
  detections.diagnostics.color_is_blank = true;
  EXPECT_THAT(ExplainLosses(detections), ElementsAre(HasSubstr("colour image shows nothing")));
}

TEST(ExplainLosses, NoSupport) {
  Detections detections = Usual();
  detections.support.reset();
  EXPECT_THAT(ExplainLosses(detections), ElementsAre(HasSubstr("no support surface was found")));
}

TEST(ExplainLosses, NoSupportNamesWhatMayBeWrong) {
  Detections detections = Usual();
  detections.support.reset();
  EXPECT_THAT(ExplainLosses(detections),
              ElementsAre(AllOf(HasSubstr("gravity was estimated wrongly (frame.gravity says it)"),
                                HasSubstr("the depth unit or the intrinsics"))));
  detections.gravity.source = Gravity::Source::kGiven;
  EXPECT_THAT(ExplainLosses(detections),
              ElementsAre(HasSubstr("frame.gravity does not point down in the camera frame")));
}

TEST(ExplainLosses, GravityOfAnUprightCameraIsNotDoubted) {
  Detections detections = Usual();
  for (const Eigen::Vector3f& down :
       {Eigen::Vector3f(0, 1, 0), Eigen::Vector3f(0.55F, 0.8F, 0.2F), Eigen::Vector3f(0, 0, 1),
        Eigen::Vector3f(0.2F, -0.2F, 0.96F), Eigen::Vector3f(-0.5F, 0.6F, -0.6F)}) {
    detections.gravity.direction = down.normalized();
    EXPECT_THAT(ExplainLosses(detections), IsEmpty()) << down.transpose();
  }
}

TEST(ExplainLosses, GravityThatWasEstimatedToOneSideIsDoubted) {
  Detections detections = Usual();
  detections.gravity.direction = Eigen::Vector3f(0, -0.67F, 0.74F).normalized();
  EXPECT_THAT(ExplainLosses(detections), ElementsAre(HasSubstr("rolled by 180 degrees")));
  detections.gravity.direction = Eigen::Vector3f(-0.8F, 0, 0.6F);
  EXPECT_THAT(ExplainLosses(detections), ElementsAre(AllOf(HasSubstr("rolled by 90 degrees"),
                                                           HasSubstr("give frame.gravity"))));
  detections.gravity.source = Gravity::Source::kGiven;
  EXPECT_THAT(ExplainLosses(detections), IsEmpty());
}

TEST(ExplainLosses, NoFreePlaceIsSaidToWhoAskedForOne) {
  Detections detections = Usual();
  EXPECT_THAT(ExplainLosses(detections), IsEmpty());
  EXPECT_THAT(ExplainLosses(detections, {.place = true}),
              ElementsAre(HasSubstr("there is no free place of the size")));
  detections.free_places.resize(1);
  EXPECT_THAT(ExplainLosses(detections, {.place = true}), IsEmpty());
}

TEST(ExplainLosses, NothingStandsOut) {
  Detections detections = Usual();
  detections.objects.clear();
  detections.diagnostics.seeds_from_color = 0;
  detections.diagnostics.seeds_from_depth = 0;
  detections.diagnostics.num_seeds = 0;
  EXPECT_THAT(ExplainLosses(detections), ElementsAre(HasSubstr("nothing stands out")));
}

TEST(ExplainLosses, NoSalientPositionBecameASeed) {
  Detections detections = Usual();
  detections.objects.clear();
  detections.diagnostics.num_seeds = 0;
  detections.diagnostics.seeds_without_depth = 3;
  detections.diagnostics.seeds_on_support = 7;
  EXPECT_THAT(ExplainLosses(detections),
              ElementsAre("none of the 10 salient positions became a seed: 3 lie where there is "
                          "no depth up to max_depth_m, 7 on, below or beside the support surface "
                          "or too high above it"));
}

TEST(ExplainLosses, AllBackground) {
  Detections detections = Usual();
  detections.objects.clear();
  detections.diagnostics.num_segments = 0;
  detections.diagnostics.num_merged = 0;
  EXPECT_THAT(ExplainLosses(detections), ElementsAre(HasSubstr("region")));
}

TEST(ExplainLosses, NothingIsLikelyEnough) {
  Detections detections = Usual();
  detections.objects.clear();
  detections.diagnostics.segments_implausible = 5;
  EXPECT_THAT(ExplainLosses(detections),
              ElementsAre(HasSubstr("5 possible objects were considered and are not likely")));
}

TEST(ExplainLosses, WhatIsTooSmallAndWhatIsNotLikelyAreBothTold) {
  Detections detections = Usual();
  detections.objects.clear();
  detections.diagnostics.segments_too_small = 5;
  const std::string small =
      "all 5 segments that may be objects are smaller than objects.min_pixels";
  EXPECT_THAT(ExplainLosses(detections), ElementsAre(small));
  detections.diagnostics.segments_implausible = 2;
  EXPECT_THAT(ExplainLosses(detections), ElementsAre(small, HasSubstr("2 possible objects")));
}

TEST(ExplainLosses, NothingIsLeftUnexplained) {
  Detections detections = Usual();
  detections.objects.clear();
  EXPECT_THAT(ExplainLosses(detections), ElementsAre(HasSubstr("none of 8 segments")));
}

TEST(ExplainLosses, SegmentsMayBeLostAsLongAsObjectsAreLeft) {
  Detections detections = Usual();
  detections.diagnostics.segments_too_small = 1;
  detections.diagnostics.segments_implausible = 1;
  EXPECT_THAT(ExplainLosses(detections), IsEmpty());
}

TEST(ExplainLosses, EarlierStepsComeFirst) {
  Detections detections = Usual();
  detections.objects.clear();
  detections.support.reset();
  detections.diagnostics.num_measured = 100;
  detections.diagnostics.segments_too_small = 5;
  EXPECT_THAT(ExplainLosses(detections),
              ElementsAre(HasSubstr("10.0 %"), HasSubstr("no support"), HasSubstr("min_pixels")));
}

}  // namespace
}  // namespace fovea
