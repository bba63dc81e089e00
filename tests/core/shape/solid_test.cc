#include "core/shape/solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

#include "core/shape/surface_samples.h"

namespace fovea {
namespace {

LevelPoints Points(std::initializer_list<Eigen::Vector3f> list) {
  LevelPoints points(static_cast<Eigen::Index>(list.size()));
  Eigen::Index i = 0;
  for (const Eigen::Vector3f& p : list) {
    points.x[i] = p.x();
    points.y[i] = p.y();
    points.h[i++] = p.z();
  }
  return points;
}

SeenArray Distances(const Solid& solid, std::initializer_list<Eigen::Vector3f> list,
                    const Eigen::Vector3f* camera = nullptr) {
  SeenArray distances;
  SignedDistances(solid, Points(list), distances, camera);
  return distances;
}

Solid Box() {
  Solid box;
  box.center = {1, 2};
  box.along = {0, 1};
  box.half_length_m = 0.2F;  // along y
  box.half_width_m = 0.1F;
  box.height_m = 0.3F;
  return box;
}

TEST(Solid, DistancesFromABoxAreThoseOfItsFacesEdgesAndCorners) {
  const SeenArray d =
      Distances(Box(), {{1, 2, 0.4F}, {1.2F, 2, 0.1F}, {1.13F, 2.24F, 0.1F}, {1.08F, 2, 0.15F}});
  EXPECT_NEAR(d[0], 0.1F, 1e-6F);
  EXPECT_NEAR(d[1], 0.1F, 1e-6F);
  EXPECT_NEAR(d[2], 0.05F, 1e-6F);  // 3-4-5 from an upright edge
  EXPECT_NEAR(d[3], -0.02F, 1e-6F);
}

TEST(Solid, InsideOfABoxTheCameraCountsFromTheFacesThatItSees) {
  const Eigen::Vector3f camera(-3, 2, 0.1F);  // level with it, on the side of small x
  const SeenArray d = Distances(Box(), {{1.08F, 2, 0.15F}, {0.93F, 2, 0.15F}}, &camera);
  EXPECT_NEAR(d[0], -0.18F, 1e-6F);
  EXPECT_NEAR(d[1], -0.03F, 1e-6F);
}

TEST(Solid, DistancesFromRoundSolids) {
  Solid solid;
  solid.radius_m = 0.05F;
  solid.height_m = 0.2F;
  solid.kind = Solid::Kind::kUprightCylinder;
  EXPECT_NEAR(Distances(solid, {{0.08F, 0, 0.1F}})[0], 0.03F, 1e-6F);
  EXPECT_NEAR(Distances(solid, {{0.08F, 0, 0.24F}})[0], 0.05F, 1e-6F);
  solid.kind = Solid::Kind::kSphere;
  EXPECT_NEAR(Distances(solid, {{0, 0.03F, 0.09F}})[0], 0, 1e-6F);  // 3-4-5 about its middle
  solid.kind = Solid::Kind::kLyingCylinder;
  solid.half_length_m = 0.1F;
  EXPECT_NEAR(Distances(solid, {{0.12F, 0, 0.05F}})[0], 0.02F, 1e-6F);
  EXPECT_NEAR(Distances(solid, {{0, 0.03F, 0.09F}})[0], 0, 1e-6F);
  solid.kind = Solid::Kind::kFrustum;
  solid.bottom_radius_m = 0.05F;
  EXPECT_NEAR(Distances(solid, {{0, 0.07F, 0.1F}})[0], 0.02F, 1e-6F);
}

TEST(Solid, AFrustumThatBulgesIsWidestWhereItsWallIsUpright) {
  Solid solid;
  solid.kind = Solid::Kind::kFrustum;
  solid.radius_m = 0.06F;
  solid.bottom_radius_m = 0.04F;
  solid.height_m = 0.1F;
  EXPECT_FLOAT_EQ(solid.WidestRadius(), 0.06F);
  solid.bulge_m = 0.02F;
  EXPECT_FLOAT_EQ(solid.RadiusAt(0), 0.04F);
  EXPECT_FLOAT_EQ(solid.RadiusAt(0.5F), 0.07F);
  EXPECT_FLOAT_EQ(solid.RadiusAt(1), 0.06F);
  EXPECT_NEAR(solid.WidestRadius(), 0.07125F, 1e-6F);  // at 5 / 8 of its height
  EXPECT_NEAR(Distances(solid, {{0, 0.08125F, 0.0625F}})[0], 0.01F, 1e-6F);
}

TEST(Solid, InsideOfAHollowOneTheWallAndTheBottomCount) {
  Solid cup;
  cup.kind = Solid::Kind::kUprightCylinder;
  cup.radius_m = 0.04F;
  cup.height_m = 0.1F;
  const SeenArray d = DistancesInside(
      cup, Points({{0.037F, 0, 0.05F}, {0, 0.031F, 0.05F}, {0, 0, 0.008F}}), 0.003F);
  EXPECT_NEAR(d[0], 0, 1e-6F);
  EXPECT_NEAR(d[1], 0.006F, 1e-6F);
  EXPECT_NEAR(d[2], 0.005F, 1e-6F);
}

TEST(Solid, DistancesFromAnOblongAndABentRod) {
  Solid solid;
  solid.kind = Solid::Kind::kOblong;
  solid.half_length_m = 0.05F;
  solid.half_width_m = 0.02F;
  solid.height_m = 0.1F;
  const SeenArray d =
      Distances(solid, {{0, 0.03F, 0.05F}, {0.06F, 0, 0.05F}, {0.06F, 0.04F, 0.05F}});
  EXPECT_NEAR(d[0], 0.01F, 1e-6F);
  EXPECT_NEAR(d[1], 0.01F, 1e-6F);
  EXPECT_NEAR(d[2], 0.03F, 1e-6F);  // 3-4-5 about the middle of its end

  solid.kind = Solid::Kind::kBent;
  solid.half_length_m = 0.1F;
  solid.radius_m = 0.02F;
  solid.bend_m = 0.03F;  // its axis from (-0.08, 0.015) by (0, -0.015) to (0.08, 0.015)
  const SeenArray bent =
      Distances(solid, {{0, -0.015F, 0.05F}, {0, -0.045F, 0.02F}, {0.11F, 0.015F, 0.02F}});
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(bent[i], 0.01F, 1e-6F) << i;
  EXPECT_NEAR(solid.Size().y(), 0.07F, 1e-6F);
}

TEST(Solid, ABentRodStaysLongerThanWide) {
  Solid solid;
  solid.kind = Solid::Kind::kBent;
  solid.half_length_m = 0.1F;
  solid.radius_m = 0.02F;
  const ParameterVector step = ParameterVector::Unit(NumParameters(solid.kind), 5);
  EXPECT_FLOAT_EQ(Moved(solid, step).bend_m, 0.16F);
  EXPECT_FLOAT_EQ(Moved(solid, -step).bend_m, -0.16F);
}

TEST(Solid, MovesByWhatDescribesIt) {
  ParameterVector step(NumParameters(Solid::Kind::kBox));
  step << 0.1F, 0, 0.01F, 0.02F, -1, 0.04F;
  const Solid moved = Moved(Box(), step);
  EXPECT_NEAR(moved.center.x(), 1.1F, 1e-6F);
  EXPECT_NEAR(std::atan2(moved.along.y(), moved.along.x()), M_PI_2 + 0.01, 1e-4);
  EXPECT_NEAR(moved.along.norm(), 1, 1e-6F);
  EXPECT_NEAR(moved.half_length_m, 0.22F, 1e-6F);
  EXPECT_FLOAT_EQ(moved.half_width_m, 0.002F);  // no smaller
  EXPECT_NEAR(moved.height_m, 0.34F, 1e-6F);
}

TEST(SampleSurface, HasTheAreaWithoutTheBottomAndLiesOnTheSolid) {
  Solid solid = Box();
  solid.radius_m = 0.1F;
  solid.bottom_radius_m = 0.07F;
  const Solid rounded = solid;
  const float pi = static_cast<float>(M_PI);
  const float slant = std::hypot(0.3F, 0.03F);
  const std::pair<Solid::Kind, float> areas[] = {
      {Solid::Kind::kBox, 0.4F * 0.2F + 2 * 0.3F * (0.4F + 0.2F)},
      {Solid::Kind::kUprightCylinder, pi * 0.01F + 2 * pi * 0.1F * 0.3F},
      {Solid::Kind::kLyingCylinder, 2 * pi * 0.01F + 2 * pi * 0.1F * 0.4F},
      {Solid::Kind::kSphere, 4 * pi * 0.01F},
      {Solid::Kind::kFrustum, pi * 0.01F + pi * (0.1F + 0.07F) * slant},
      {Solid::Kind::kOblong, 0.04F + pi * 0.01F + 0.3F * (0.4F + 2 * pi * 0.1F)},
      {Solid::Kind::kBent, 2 * pi * 0.08F * (0.24F + 2 * 0.08F)}};
  for (const auto& [kind, area] : areas) {
    solid = rounded;
    solid.kind = kind;
    if (kind == Solid::Kind::kOblong) solid.half_width_m = 0.1F;
    if (kind == Solid::Kind::kBent) solid.radius_m = 0.08F;
    float sum = 0;
    for (const SurfaceSample& sample : SampleSurface(solid)) {
      sum += sample.area_m2;
      EXPECT_NEAR(sample.normal.norm(), 1, 1e-5F);
      const Eigen::Vector3f outside = sample.position + 0.01F * sample.normal;
      EXPECT_NEAR(Distances(solid, {sample.position})[0], 0, 1e-5F);
      EXPECT_NEAR(Distances(solid, {outside})[0], 0.01F, 1e-4F);
    }
    EXPECT_NEAR(sum, area, 0.005F * area) << static_cast<int>(kind);
  }
}

}  // namespace
}  // namespace fovea
