// Where fingers meet an object, and whether two contacts are opposite each other.
#include "core/grasping/jaw_contacts.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace fovea {
namespace {

JawContact Touching(const Span& across_m, const Span& above_tip_m) {
  JawContact contact;
  contact.across_m = across_m;
  contact.above_tip_m = above_tip_m;
  return contact;
}

TEST(LineBetween, IsStraightWhereContactsOverlap) {
  const JawContact left = Touching({-0.01F, 0.01F}, {0.001F, 0.01F});
  const JawContact right = Touching({0.005F, 0.01F}, {0.01F, 0.024F});
  EXPECT_EQ(LineBetween({left, right}, 0.05F), Eigen::Vector2f::Zero());
}

TEST(LineBetween, LeansAsFarAsContactsAreApartOnAThinWall) {
  // The outside of a leaning wall is touched at its top, the inside 9 mm lower.
  const JawContact outside = Touching({-0.01F, 0.01F}, {0.01F, 0.01F});
  const JawContact inside = Touching({0.012F, 0.014F}, {0.001F, 0.001F});
  for (const auto& contacts : {std::array{inside, outside}, std::array{outside, inside}}) {
    const Eigen::Vector2f line = LineBetween(contacts, 0.005F);
    EXPECT_NEAR(line.x(), 0.4F, 1e-4F);
    EXPECT_NEAR(line.y(), 1.8F, 1e-4F);
  }
}

// A cylinder of 100 mm that stands in the middle, 60 mm high, in a grid of 4 mm.
class AroundACylinder : public ::testing::Test {
 protected:
  AroundACylinder() {
    object_.shape.kind = Shape::Kind::kCylinder;
    object_.shape.axis = Eigen::Vector3f::UnitZ();
    object_.shape.radius_m = 0.05F;
    object_.shape.length_m = 0.06F;
    object_.box.size_m = {0.1F, 0.1F, 0.06F};
    grid_.size = 50;
    grid_.columns.resize(50UL * 50);
    for (int row = 0; row < grid_.size; ++row) {
      for (int column = 0; column < grid_.size; ++column) {
        const float away = std::hypot(grid_.MiddleOf(row), grid_.MiddleOf(column));
        if (away < 0.05F) grid_.At(row, column).target = 0.03F;
      }
    }
    turned_ = Turned(grid_, Eigen::Vector2f::UnitX(), 0.1F);
  }

  // Fingers of 20 mm, 12 mm deep, so far from the middle; of rows from `first` on.
  std::array<JawContact, 2> CloseOn(float across_m, bool is_part) {
    JawPlace place;
    place.across_m = across_m;
    place.first_row = static_cast<int>((across_m + 0.09F) / grid_.cell_m);
    place.last_row = place.first_row + 4;
    place.last_column = grid_.size - 1;
    place.tip_m = 0.018F;
    place.is_part = is_part;
    return JawCloser(turned_, CompletedSolid(object_, LevelFrame()), JawGripper()).CloseOn(place);
  }

  DetectedObject object_;
  HandGrid grid_;
  TurnedGrid turned_;
};

TEST_F(AroundACylinder, FingersMeetTheSolidOnBothSides) {
  const auto contacts = CloseOn(0, false);
  EXPECT_NEAR(contacts[0].along_m, -0.05F, 1e-6F);
  EXPECT_NEAR(contacts[1].along_m, 0.05F, 1e-6F);
  for (const JawContact& contact : contacts) {
    EXPECT_NEAR(contact.slope_across, 0, 1e-4F);
    EXPECT_NEAR(contact.slope_down, 0, 1e-4F);
    EXPECT_EQ(contact.share, 1);  // 1 mm behind the first to touch at its ends
    EXPECT_NEAR(contact.above_tip_m.high, 0.01F, 1e-6F);
  }
}

// 30 mm from the middle, between 20 and 40, what is in front of a pad falls back by 16 mm.
TEST_F(AroundACylinder, WhatIsBesideTheMiddleSlopes) {
  const auto contacts = CloseOn(0.03F, false);
  EXPECT_NEAR(contacts[1].along_m, std::sqrt(0.05F * 0.05F - 0.02F * 0.02F), 1e-6F);
  EXPECT_LT(contacts[1].slope_across, -0.4F);
  EXPECT_NEAR(contacts[1].share, 0, 1e-6F);  // its edge alone touches
}

// 50 mm from it, what is in front of the next row of the pad lies 8 mm behind the first.
TEST_F(AroundACylinder, WhereOneRowTouchesTheNextTellsTheSlope) {
  for (const JawContact& contact : CloseOn(0.05F, false)) {
    EXPECT_NEAR(std::abs(contact.along_m), 0.03F, 1e-6F);
    EXPECT_LT(contact.slope_across, -1.2F);
  }
}

TEST_F(AroundACylinder, OfAPartTheColumnsTell) {
  const auto contacts = CloseOn(0, true);
  EXPECT_NEAR(contacts[0].along_m, -0.05F, grid_.cell_m);
  EXPECT_NEAR(contacts[1].along_m, 0.05F, grid_.cell_m);
  EXPECT_NE(contacts[1].along_m, CloseOn(0, false)[1].along_m);
}

}  // namespace
}  // namespace fovea
