// Free places are where the support was seen.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "tests/core/relations/table.h"

namespace fovea {
namespace {

// Across the middle of the table, 16 cm long, at some angle to the cells.
struct Strip {
  float width_m;
  float angle_rad = 0.4F;

  bool Contains(const Eigen::Vector2f& at) const {
    const Eigen::Vector2f across(std::cos(angle_rad), std::sin(angle_rad));
    return at.norm() < 0.08F && std::abs(at.dot(across)) <= width_m / 2;
  }
};

void PutStrip(Table& table, const Strip& strip, const auto& what) {
  table.ForEach([&](const Eigen::Vector2f& at, const cv::Point& pixel) {
    if (strip.Contains(at)) what(table.points.at<cv::Vec3f>(pixel));
  });
}

// Whether a place lies on some of a strip.
bool IsOn(const FreePlace& place, const Strip& strip) {
  bool is_on = false;
  Table(100).ForEach([&](const Eigen::Vector2f& at, const cv::Point&) {
    const Eigen::Vector3f beside = Eigen::Vector3f(at.x(), at.y(), 1) - place.box.center;
    const Eigen::Vector3f within = place.box.rotation.transpose() * beside;
    is_on |= strip.Contains(at) && std::abs(within.x()) < place.box.size_m.x() / 2 &&
             std::abs(within.y()) < place.box.size_m.y() / 2;
  });
  return is_on;
}

// Of an empty table, it is in the middle.
const PlaceOptions kPlace{.size_m = {0.3F, 0.2F, 0.1F}, .max_places = 1};

TEST(FindFreePlaces, WhatGivesNoDepthIsNotFreeHoweverThin) {
  for (const int pixels_per_m : {250, 100}) {
    EXPECT_TRUE(IsOn(Table(pixels_per_m).Places(kPlace).at(0), {0.015F}));
    for (const float angle_rad : {0.0F, 0.4F, 0.8F}) {
      for (const float width_m : {0.016F, 0.035F}) {
        Table table(pixels_per_m);
        PutStrip(table, {width_m, angle_rad}, [](cv::Vec3f& p) { p = cv::Vec3f::all(kNone); });
        EXPECT_FALSE(IsOn(table.Places(kPlace).at(0), {width_m, angle_rad}))
            << width_m << " m wide, " << angle_rad << " rad, " << pixels_per_m << " pixels a metre";
      }
    }
  }
}

// One pixel in 25 mm: the cells of two that miss it are not side by side.
TEST(FindFreePlaces, WhatGivesNoDepthIsNotFreeWhereTheCameraSeesThinly) {
  Table table(40);
  PutStrip(table, {0.02F, 0}, [](cv::Vec3f& p) { p = cv::Vec3f::all(kNone); });
  EXPECT_FALSE(IsOn(table.Places(kPlace).at(0), {0.02F, 0}));
}

// As where a surface was assumed in a hole of the depth.
TEST(FindFreePlaces, PointsThatNobodyMeasuredAreNotSeen) {
  const Strip strip{0.08F};
  Table table;
  EXPECT_TRUE(IsOn(table.Places(kPlace).at(0), strip));
  table.ForEach([&](const Eigen::Vector2f& at, const cv::Point& pixel) {
    if (strip.Contains(at)) table.frame.depth_m.at<float>(pixel) = kNone;
  });
  EXPECT_FALSE(IsOn(table.Places(kPlace).at(0), strip));
}

// One in twenty has no depth, and one in twenty was measured but is taken for no surface.
TEST(FindFreePlaces, SinglePixelsThatAreMissingAreAsWhatIsAround) {
  for (const int pixels_per_m : {250, 100}) {
    Table table(pixels_per_m);
    const float all_m = table.Places(kPlace).at(0).clearance_m;
    int count = 0;
    table.ForEach([&](const Eigen::Vector2f&, const cv::Point& pixel) {
      count += 7;
      if (count % 10 == 0) table.points.at<cv::Vec3f>(pixel) = cv::Vec3f::all(kNone);
      if (count % 20 == 0) table.frame.depth_m.at<float>(pixel) = kNone;
    });
    const auto places = table.Places(kPlace);
    ASSERT_EQ(places.size(), 1U);
    EXPECT_NEAR(places[0].clearance_m, all_m, 0.011F) << pixels_per_m;
  }
}

// Flying pixels of a surface that is seen flatly, and of what hangs in front of it.
TEST(FindFreePlaces, WhatWasMeasuredButIsNoSurfaceIsAsWhatIsAroundUnlessItHidesThat) {
  const Strip strip{0.025F};
  for (const float height_m : {0.0F, 0.3F}) {
    Table table;
    PutStrip(table, strip, [&](cv::Vec3f& p) { p[2] = 1 - height_m; });
    cv::extractChannel(table.points, table.frame.depth_m, 2);
    PutStrip(table, strip, [](cv::Vec3f& p) { p = cv::Vec3f::all(kNone); });
    EXPECT_EQ(IsOn(table.Places(kPlace).at(0), strip), height_m == 0);
  }
}

TEST(FindFreePlaces, AGapThroughWhichTheFloorIsSeenIsNotFree) {
  Table table;
  PutStrip(table, {0.03F}, [](cv::Vec3f& p) { p *= 1.3F; });
  EXPECT_FALSE(IsOn(table.Places(kPlace).at(0), {0.03F}));
}

TEST(FindFreePlaces, LowThingsAreInTheWayWithTheirMasksAndBoxes) {
  const Strip within{0.08F};
  const DetectedObject flat = Thing({0, 0}, {0.2F, 0.2F, 0.002F});
  EXPECT_FALSE(IsOn(Table().Places(kPlace, {flat}).at(0), within));

  Table with_mask;  // that goes on beyond the box
  with_mask.Put({-0.1F, -0.1F}, {0.1F, 0.1F}, 0.002F, 1);
  const DetectedObject beside = Thing({0.45F, 0.25F}, {0.01F, 0.01F, 0.002F});
  EXPECT_FALSE(IsOn(with_mask.Places(kPlace, {beside}).at(0), within));
}

// A board on the floor, whose top is the table.
TEST(FindFreePlaces, WhatCarriesTheSupportIsNotInTheWay) {
  Table table;
  table.labels.setTo(1);
  DetectedObject board = Thing({0, 0}, {1, 0.6F, 0.3F});
  board.box.center.z() = 1 + 0.15F;
  EXPECT_EQ(table.Places(kPlace, {board}).size(), 1U);
}

// 8 mm: beyond the scatter of a support whose tolerance is 4 mm, within that of one of 10 mm.
TEST(FindFreePlaces, WhatRisesAboveTheScatterOfTheSupportIsInTheWay) {
  Table table;
  PutStrip(table, {0.03F}, [](cv::Vec3f& p) { p *= 0.992F; });
  EXPECT_FALSE(IsOn(table.Places(kPlace).at(0), {0.03F}));
  EXPECT_TRUE(IsOn(table.Places(kPlace, {}, {.tolerance_m = 0.01}).at(0), {0.03F}));
}

}  // namespace
}  // namespace fovea
