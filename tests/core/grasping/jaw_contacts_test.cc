// Whether two contacts are opposite each other.
#include "core/grasping/jaw_contacts.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace fovea
