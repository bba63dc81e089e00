#include "core/segmentation/kinship.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fovea {
namespace {

// Two faces of 10 × 20 cm side by side at 1 m, of one colour, that meet along 20 pairs of voxels.
struct TwoFaces {
  TwoFaces() {
    left.num_voxels = right.num_voxels = 200;
    left.z_sum_m = right.z_sum_m = 200;
    left.area_m2 = right.area_m2 = 0.02;
    left.extent = {Eigen::Vector3f(0, 1, 0), Eigen::Vector3f(0.1F, 1.02F, 0.2F)};
    right.extent = {Eigen::Vector3f(0.1F, 1, 0), Eigen::Vector3f(0.2F, 1.02F, 0.2F)};
    left.color.num_pixels = right.color.num_pixels = 1;
    boundary.num_pairs = 20;
    boundary.way_sum_m2 = 20 * 1e-4;
  }
  Kinship Of() const { return KinshipOf(boundary, left, right); }
  double Odds() const { return LogOdds(Of()); }

  Part left, right;
  Boundary boundary;
};

TEST(Kinship, OneEvenSurfaceIsOneObject) { EXPECT_GT(TwoFaces().Odds(), 2); }

TEST(Kinship, SaysWhatIsMeasured) {
  TwoFaces faces;
  faces.right.extent.max().z() = 0.1F;
  faces.boundary.rise_sum_m2 = faces.boundary.way_sum_m2 / 4;
  const Kinship kinship = faces.Of();
  EXPECT_EQ(kinship.unevenness, 0);
  EXPECT_EQ(kinship.color_likeness, 1);
  EXPECT_EQ(kinship.color_continuity, 1);
  EXPECT_NEAR(kinship.top_step, 0.5, 1e-6);
  EXPECT_NEAR(kinship.height_m, 0.2, 1e-6);
  EXPECT_NEAR(kinship.height_overlap, 0.5, 1e-6);
  EXPECT_NEAR(kinship.depth_overlap, 1, 1e-6);
  EXPECT_NEAR(kinship.side_step, 0.5, 1e-6);
  EXPECT_NEAR(kinship.log_area, std::log(0.04), 1e-9);
  EXPECT_NEAR(kinship.log_area_ratio, 0, 1e-9);
  EXPECT_NEAR(kinship.contact, std::log(20 / std::sqrt(200)), 1e-9);
  EXPECT_NEAR(kinship.distance_m, 1, 1e-9);
  EXPECT_NEAR(kinship.rise, 0.25, 1e-9);
}

// Heights of 20 and 2.5 cm.
TEST(Kinship, TheLowerAndTheSmallerOfBothCount) {
  TwoFaces faces;
  faces.right.extent.max().z() = 0.025F;
  faces.right.num_voxels = 25;
  faces.boundary.convexity_sum_deg = 40 * faces.boundary.num_pairs;
  const Kinship kinship = faces.Of();
  EXPECT_NEAR(kinship.flatness, std::exp(-1), 1e-6);
  EXPECT_NEAR(kinship.convexity_deg, 40 * (1 - std::exp(-1)), 1e-4);
  EXPECT_NEAR(kinship.contact, std::log(20 / 5), 1e-9);
}

TEST(Kinship, WhatIsApartHasNoExtentInCommon) {
  TwoFaces faces;
  faces.right.extent.translate(Eigen::Vector3f(0, 0.1F, 0.3F));
  EXPECT_EQ(faces.Of().depth_overlap, 0);
  EXPECT_EQ(faces.Of().height_overlap, 0);
}

// A few millimetres are noise: shares of a small extent would say much where there is nothing.
TEST(Kinship, MillimetersOfSmallThingsSayLittle) {
  TwoFaces crumbs;
  crumbs.left.extent = {Eigen::Vector3f(0, 1, 0), Eigen::Vector3f(0.003F, 1.002F, 0.01F)};
  crumbs.right.extent = {Eigen::Vector3f(0.001F, 1, 0), Eigen::Vector3f(0.005F, 1.001F, 0.005F)};
  const Kinship kinship = crumbs.Of();
  EXPECT_NEAR(kinship.side_step, 0.001 / 0.01, 1e-5);
  EXPECT_NEAR(kinship.depth_overlap, 0.001 / 0.01, 1e-4);
  EXPECT_NEAR(kinship.top_step, 0.005 / 0.05, 1e-6);
  EXPECT_NEAR(kinship.height_overlap, 0.005 / 0.05, 1e-6);
}

// The scenes of the fit end there.
TEST(Kinship, BeyondThreeMetersDistanceSaysNoMore) {
  TwoFaces far;
  far.left.z_sum_m = far.right.z_sum_m = 5 * 200;
  EXPECT_EQ(far.Of().distance_m, 3);
}

TEST(Kinship, GroovesAndStepsSpeakAgainstOneObject) {
  TwoFaces groove;
  groove.boundary.convexity_sum_deg = -40 * groove.boundary.num_pairs;
  EXPECT_LT(groove.Odds(), TwoFaces().Odds() - 3);
  TwoFaces step;
  step.boundary.step_sum_deg = 40 * step.boundary.num_pairs;
  EXPECT_LT(step.Odds(), TwoFaces().Odds() - 3);
}

TEST(Kinship, AnEdgeSpeaksLessAgainstItThanAGroove) {
  TwoFaces edge, groove;
  edge.boundary.convexity_sum_deg = 80 * edge.boundary.num_pairs;
  groove.boundary.convexity_sum_deg = -edge.boundary.convexity_sum_deg;
  EXPECT_GT(edge.Odds(), groove.Odds() + 2);
}

TEST(Kinship, OtherColorsSpeakAgainstIt) {
  TwoFaces faces;
  faces.right.color.sum = {24, 0, 0};
  const double of_means = faces.Odds();
  EXPECT_LT(of_means, TwoFaces().Odds() - 3);
  faces.boundary.contrast_sum = 24 * faces.boundary.num_pairs;
  EXPECT_LT(faces.Odds(), of_means - 2);  // and where they meet
}

TEST(Kinship, TopsOfUnequalHeightSpeakAgainstIt) {
  TwoFaces faces;
  faces.right.extent.max().z() = 0.14F;
  EXPECT_LT(faces.Odds(), TwoFaces().Odds() - 1);
}

TEST(Kinship, SidesOfFarThingsThatDifferSpeakAgainstIt) {
  TwoFaces one_side;  // one above the other, as drawers are
  one_side.right.extent = one_side.left.extent;
  EXPECT_GT(one_side.Odds(), TwoFaces().Odds());
}

TEST(Kinship, WhatLiesOnTopBelongsToIt) {
  TwoFaces beside;
  beside.boundary.convexity_sum_deg = 80 * beside.boundary.num_pairs;
  TwoFaces over = beside;
  over.boundary.rise_sum_m2 = over.boundary.way_sum_m2;
  EXPECT_GT(over.Odds(), beside.Odds() + 2);
}

TEST(Kinship, FlatThingsOfOneDepthBelongTogether) {
  TwoFaces apart;
  apart.left.extent.max().z() = apart.right.extent.max().z() = 0.005F;
  apart.right.extent.min().y() = 1.02F;
  apart.right.extent.max().y() = 1.04F;
  TwoFaces level = apart;
  level.right.extent = TwoFaces().right.extent;
  level.right.extent.max().z() = 0.005F;
  EXPECT_GT(level.Odds(), apart.Odds() + 3);
}

// What each thing is worth where all others are as between two faces of a carton, for a change of
// one unit: as fitted, to be renewed with the weights.
TEST(Kinship, HasTheSlopesOfItsFit) {
  const Kinship usual{.unevenness = 0.5,
                      .color_likeness = 0.8,
                      .top_step = 0.2,
                      .height_m = 0.2,
                      .log_area = -3,
                      .distance_m = 1,
                      .flatness = 0.1,
                      .convexity_deg = 10,
                      .color_continuity = 0.7,
                      .contact = 0.5,
                      .log_area_ratio = -1,
                      .log_smaller_area = -4,
                      .side_step = 0.3,
                      .depth_overlap = 0.5,
                      .height_overlap = 0.9,
                      .rise = 0.1};
  struct Slope {
    double Kinship::*of;
    double value;
  };
  for (const auto& [of, value] :
       {Slope{&Kinship::unevenness, -9.2300}, Slope{&Kinship::color_likeness, 9.3220},
        Slope{&Kinship::top_step, -9.7236}, Slope{&Kinship::height_m, 5.1360},
        Slope{&Kinship::log_area, -0.4132}, Slope{&Kinship::distance_m, 0.2476},
        Slope{&Kinship::flatness, 4.4319}, Slope{&Kinship::convexity_deg, 0.0240},
        Slope{&Kinship::color_continuity, 3.4630}, Slope{&Kinship::contact, 0.2991},
        Slope{&Kinship::log_area_ratio, -0.1496}, Slope{&Kinship::log_smaller_area, -0.4044},
        Slope{&Kinship::side_step, -5.4280}, Slope{&Kinship::depth_overlap, 0.8127},
        Slope{&Kinship::height_overlap, 0.4219}, Slope{&Kinship::rise, 3.7971}}) {
    Kinship more = usual, less = usual;
    more.*of += 0.5;
    less.*of -= 0.5;
    EXPECT_NEAR(LogOdds(more) - LogOdds(less), value, 1e-3);
  }
}

}  // namespace
}  // namespace fovea
