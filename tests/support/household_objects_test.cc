// The forms look like what they are named after, for several seeds.
#include "tests/support/household_objects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "tests/support/household_forms.h"
#include "tests/support/random_objects.h"

namespace fovea::scenes {
namespace {

using Eigen::Vector3d;

constexpr std::uint64_t kSeeds = 20;

std::optional<Hit> FromAbove(const Shape& shape, double x, double y) {
  return Intersect(shape, {{x, y, 1}, {0, 0, -1}});
}

TEST(HouseholdObjects, AMugHasAHandleThatOneCanReachThrough) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Random random(seed);
    const Shape mug = Mug(random).shape;
    const double handle = mug.size_m.x() / 2 - 0.005, hole = mug.size_m.x() / 2 - 0.02;
    const auto along_y = [&](double x) { return Intersect(mug, {{x, 1, 0}, {0, -1, 0}}); };
    EXPECT_TRUE(along_y(handle)) << "seed " << seed;
    EXPECT_FALSE(along_y(hole)) << "seed " << seed;
    EXPECT_TRUE(along_y(0)) << "seed " << seed;
  }
}

TEST(HouseholdObjects, HandlesDoNotShowWithinVessels) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    for (const auto form : {Mug, Pitcher, Pan}) {
      Random random(seed);
      const Body body = form(random);
      const Part& vessel = body.shape.parts.at(0);
      ASSERT_EQ(vessel.shape.kind, ShapeKind::kCup);
      const Vector3d middle = vessel.shape_from_part.translation();
      const double inner_m = vessel.shape.size_m.x() / 2 - vessel.shape.wall_m;
      for (int degrees = -180; degrees < 180; degrees += 2) {
        for (const double share : {0.2, 0.5, 0.8, 0.9}) {
          const double angle = degrees * std::numbers::pi / 180;
          Vector3d from = middle;
          from.z() += (share - 0.5) * vessel.shape.size_m.z();
          const auto hit = Intersect(body.shape, {from, {std::cos(angle), std::sin(angle), 0}});
          ASSERT_TRUE(hit) << body.name;
          EXPECT_NEAR(hit->t, inner_m, 1e-9) << body.name << ", seed " << seed;
        }
      }
    }
  }
}

TEST(HouseholdObjects, ABottleHasACapAboveANarrowNeckAndAShoulder) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Random random(seed);
    const Shape bottle = Bottle(random).shape;
    const double top = bottle.size_m.z() / 2, radius = bottle.size_m.x() / 2;
    const auto cap = FromAbove(bottle, 0, 0);
    ASSERT_TRUE(cap);
    EXPECT_NEAR(cap->t, 1 - top, 1e-12);
    EXPECT_EQ(cap->normal, Vector3d::UnitZ());
    EXPECT_EQ(cap->material, 1);
    const auto shoulder = FromAbove(bottle, 0.9 * radius, 0);
    ASSERT_TRUE(shoulder);
    EXPECT_GT(shoulder->t, 1 - top + 0.03);
    EXPECT_EQ(shoulder->material, 0);
    EXPECT_NEAR(shoulder->normal.x(), 0.9, 0.02);
    const auto side = Intersect(bottle, {{1, 0, -top + 0.01}, {-1, 0, 0}});
    ASSERT_TRUE(side);
    EXPECT_TRUE(side->normal.isApprox(Vector3d::UnitX(), 1e-9));
  }
}

// Of the objects that `draw` gives, those that are not of random_objects.h.
std::set<std::string> NamesOfForms(Body (*draw)(Random&), const std::set<std::string>& flat,
                                   double longest_m = 0.45) {
  std::set<std::string> names;
  const std::set<std::string> simple = {"box", "book", "can", "tube", "ball", "bowl", "cup"};
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    const Body body = draw(random);
    EXPECT_NEAR(VerticalExtent(body).first, 0, 1e-9);
    if (simple.count(body.name) > 0) continue;
    names.insert(body.name);
    EXPECT_EQ(HasFlatTop(body), flat.count(body.name) > 0) << body.name;
    EXPECT_LT(body.shape.size_m.maxCoeff(), longest_m) << body.name;
    for (const Part& part : body.shape.parts) {
      EXPECT_NO_THROW(MaterialAt(body, {0, Vector3d::UnitZ(), part.material})) << body.name;
    }
  }
  return names;
}

TEST(HouseholdObjects, AllFormsComeUpAndStandOnZero) {
  EXPECT_EQ(NamesOfForms(RandomHouseholdObject, {}),
            (std::set<std::string>{"mug", "bottle", "flat bottle", "drill", "pitcher", "pan",
                                   "spray bottle", "banana", "hammer", "wrench"}));
  EXPECT_EQ(NamesOfForms(RandomSupply, {"slab"}),
            (std::set<std::string>{"bag", "cloth", "plate", "slab", "keyboard", "torch", "pear"}));
  EXPECT_EQ(NamesOfForms(RandomTool, {"slab"}),
            (std::set<std::string>{"spoon", "knife", "scissors", "screwdriver", "brush", "whisk",
                                   "hammer", "wrench", "torch", "plate", "slab"}));
  EXPECT_EQ(NamesOfForms(RandomLuggage, {"carton"}, 0.7),
            (std::set<std::string>{"carton", "backpack", "slipper"}));
}

TEST(HouseholdObjects, ThinToolsAreThinAndScissorsHaveRingsThatOneCanSeeThrough) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    for (const auto form : {Spoon, Knife, Scissors}) {
      Random random(seed);
      const Body body = form(random);
      EXPECT_LT(body.shape.size_m.z(), 0.02) << body.name << ", seed " << seed;
    }
    Random random(seed);
    const Shape scissors = Scissors(random).shape;
    const double ring_m = 0.5 * scissors.size_m.y() / 2;  // half of the width: the middle of a ring
    bool any_hole = false, any_rim = false;
    for (double x = -scissors.size_m.x() / 2; x < -0.2 * scissors.size_m.x(); x += 0.002) {
      (FromAbove(scissors, x, ring_m) ? any_rim : any_hole) = true;
    }
    EXPECT_TRUE(any_rim && any_hole) << "seed " << seed;
  }
}

}  // namespace
}  // namespace fovea::scenes
