#include "core/relations/free_places.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/relations/table.h"

namespace fovea {
namespace {

// Half of what a box covers along x and y of the camera.
Eigen::Vector2f Reach(const OrientedBox& box) {
  return (box.rotation.leftCols<2>().cwiseAbs() * box.size_m.head<2>()).head<2>() / 2;
}

TEST(FindFreePlaces, OfAnEmptyTableTheMiddleHasTheMostRoom) {
  const auto places = Table().Places({.size_m = {0.2F, 0.1F, 0.15F}, .max_places = 1});
  ASSERT_EQ(places.size(), 1U);
  const OrientedBox& box = places[0].box;
  EXPECT_NEAR(box.center.y(), 0, 0.03F);
  EXPECT_NEAR(box.center.z(), 1 - 0.075F, 1e-3F);  // stands on the table
  EXPECT_TRUE(box.size_m.isApprox(Eigen::Vector3f(0.2F, 0.1F, 0.15F)));
  EXPECT_NEAR(box.rotation.determinant(), 1, 1e-5F);
  // The long side along the table: 0.3 - 0.05 to the edge.
  EXPECT_NEAR(places[0].clearance_m, 0.25F, 0.04F);
}

TEST(FindFreePlaces, StaysOnTheTableBesideThingsAndItsOtherPlaces) {
  Table table;
  table.Put({-0.1F, -0.3F}, {0.1F, 0.3F}, 0.08F);
  const PlaceOptions options{.size_m = {0.15F, 0.12F, 0.1F}, .margin_m = 0.03F, .max_places = 20};
  const auto places = table.Places(options);
  ASSERT_GT(places.size(), 3U);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const OrientedBox& box = places[i].box;
    const Eigen::Vector2f reach = Reach(box), at = box.center.head<2>().cwiseAbs();
    EXPECT_LT(at.x() + reach.x(), 0.5F - 0.02F);
    EXPECT_LT(at.y() + reach.y(), 0.3F - 0.02F);
    EXPECT_GT(at.x() - reach.x(), 0.1F + 0.01F);
    EXPECT_GE(places[i].clearance_m, options.margin_m);
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GT((box.center - places[j].box.center).norm(), 0.12F);
      EXPECT_LE(places[i].clearance_m, places[j].clearance_m);
    }
  }
}

TEST(FindFreePlaces, WhatIsHiddenIsNotFreeAndWhatIsHigherIsNotInTheWay) {
  const PlaceOptions low{.size_m = {0.3F, 0.3F, 0.1F}, .max_places = 1};
  Table table;
  table.Put({-0.5F, -0.3F}, {0.5F, 0.3F}, kNone);
  EXPECT_TRUE(table.Places(low).empty());

  Table under_a_lamp;
  under_a_lamp.Put({-0.05F, -0.3F}, {0.05F, 0.3F}, 0.5F);
  const auto places = under_a_lamp.Places(low);
  ASSERT_EQ(places.size(), 1U);
  EXPECT_GT(std::abs(places[0].box.center.x()), 0.15F);  // beside what the lamp hides
}

TEST(FindFreePlaces, OfThingsTheHiddenPartTakesRoomToo) {
  Table table;
  const DetectedObject object = Thing({0.25F, 0}, {0.5F, 0.6F, 0.1F});
  const auto places = table.Places({.size_m = {0.1F, 0.1F, 0.1F}}, {object});
  ASSERT_FALSE(places.empty());
  for (const FreePlace& place : places) EXPECT_LT(place.box.center.x() + 0.05F, 0);
}

// A lamp that hangs 0.5 m above the right half of the table, beside which the camera looks through.
TEST(FindFreePlaces, WhatHangsHigherThanTheThingIsNotInItsWay) {
  Table table;
  for (int col = 0; col < table.points.cols; ++col) {
    const float along = static_cast<float>(col) / static_cast<float>(table.points.cols);
    table.points.at<cv::Vec3f>(0, col) = {0.5F * along, 0.2F * (along - 0.5F), 0.5F};
  }
  const float above_m = Table().Places({.size_m = {0.8F, 0.4F, 0.3F}})[0].clearance_m;
  const auto under_it = table.Places({.size_m = {0.8F, 0.4F, 0.3F}});
  ASSERT_FALSE(under_it.empty());
  EXPECT_EQ(under_it[0].clearance_m, above_m);
  for (const FreePlace& place : table.Places({.size_m = {0.2F, 0.2F, 0.6F}})) {
    EXPECT_LT(place.box.center.x() - 0.1F, 0.4F) << "in the lamp";
    EXPECT_FALSE(std::abs(place.box.center.y()) < 0.05F && place.box.center.x() > 0) << "in it";
  }
}

TEST(FindFreePlaces, AThingThatHangsAboveIsNotInTheWayEither) {
  DetectedObject shelf;
  shelf.box.center = {0, 0, 0.4F};
  shelf.box.rotation << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  shelf.box.size_m = {1, 0.6F, 0.1F};
  EXPECT_FALSE(Table().Places({.size_m = {0.2F, 0.2F, 0.3F}}, {shelf}).empty());
  EXPECT_TRUE(Table().Places({.size_m = {0.2F, 0.2F, 0.6F}}, {shelf}).empty());
  // Its underside is 0.55 m above the table: the margin is kept there, too.
  EXPECT_FALSE(Table().Places({.size_m = {0.2F, 0.2F, 0.52F}}, {shelf}).empty());
  EXPECT_TRUE(Table().Places({.size_m = {0.2F, 0.2F, 0.54F}}, {shelf}).empty());
}

// A strip of 0.16 m across the table, at 45 degrees.
TEST(FindFreePlaces, TriesDirectionsThatAreNotAlongTheView) {
  Table table;
  for (int row = 0; row < table.points.rows; ++row) {
    for (int col = 0; col < table.points.cols; ++col) {
      auto& point = table.points.at<cv::Vec3f>(row, col);
      if (std::abs(point[0] - point[1]) > 0.08F * 1.41421F) point = cv::Vec3f::all(kNone);
    }
  }
  const auto places = table.Places({.size_m = {0.5F, 0.06F, 0.1F}, .margin_m = 0.02F});
  ASSERT_FALSE(places.empty());
  const Eigen::Vector3f along = places[0].box.rotation.col(0);
  EXPECT_NEAR(std::abs(along.x()), std::sqrt(0.5F), 1e-3F);
  EXPECT_GT(along.x() * along.y(), 0);
}

// A strip at 45 degrees as wide as what shall stand there, in whose middle a thing of one cell
// stands.
TEST(FindFreePlaces, OnNoThingHoweverThinInAnyDirection) {
  constexpr float kHalf = 0.70710678F;
  const Eigen::Vector2f along(kHalf, kHalf), across(-kHalf, kHalf);
  for (int step = -11; step <= 17; step += 4) {
    Table table;
    table.ForEach([&](const Eigen::Vector2f& at, const cv::Point& pixel) {
      if (std::abs(at.dot(across)) > 0.06F)
        table.points.at<cv::Vec3f>(pixel) = cv::Vec3f::all(kNone);
    });
    const Eigen::Vector2f at = along * (0.004F * static_cast<float>(step));
    const DetectedObject pen = Thing(at, {0.004F, 0.004F, 0.15F});
    const auto places = table.Places({.size_m = {0.2F, 0.06F, 0.1F}, .margin_m = 0.01F}, {pen});
    ASSERT_FALSE(places.empty());
    for (const FreePlace& place : places) {
      const Eigen::Vector3f beside =
          place.box.rotation.transpose() * (pen.box.center - place.box.center);
      EXPECT_GT(std::abs(beside.x()), 0.1F) << "pen at " << at.transpose();
    }
  }
}

// The table once more, 0.3 m nearer, without what a thing covers of it.
TEST(FindFreePlaces, OfSeveralSupportsTheOneWithMoreRoomComesFirst) {
  Table table;
  table.Put({-0.5F, -0.3F}, {0.1F, 0.3F}, 0.3F);
  table.supports.insert(table.supports.begin(),
                        {{-Eigen::Vector3f::UnitZ(), 1, 1000}, Footprint(), 1});
  table.supports[1].surface.offset_m = 0.7F;
  const auto places = table.Places({.size_m = {0.1F, 0.1F, 0.1F}, .max_places = 3});
  ASSERT_EQ(places.size(), 3U);
  EXPECT_NEAR(places[0].box.center.z(), 0.7F - 0.05F, 1e-3F);
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_LE(places[i].clearance_m, places[i - 1].clearance_m);
  }
}

// 0.3 m to the edges, less half of the thing, which takes an odd number of cells of 1 cm.
TEST(FindFreePlaces, ClearanceCountsFromTheThing) {
  const auto with = [](float margin_m) {
    return Table().Places({.size_m = {0.3F, 0.2F, 0.1F}, .margin_m = margin_m, .max_places = 1});
  };
  EXPECT_NEAR(with(0.02F).at(0).clearance_m, 0.19F, 0.015F);
  EXPECT_NEAR(with(0.15F).at(0).clearance_m, 0.19F, 0.015F);
  EXPECT_TRUE(with(0.21F).empty());
}

// Two cells of 1 cm in three have no pixel.
TEST(FindFreePlaces, BetweenPixelsOfACameraThatSeesThinlyIsAsFreeAsAround) {
  const PlaceOptions options{.size_m = {0.3F, 0.2F, 0.1F}, .max_places = 1};
  const auto places = Table(40).Places(options);
  ASSERT_EQ(places.size(), 1U);
  EXPECT_NEAR(places[0].clearance_m, Table().Places(options).at(0).clearance_m, 0.03F);
}

// A strip of 15.2 cm: 16 cells of 1 cm.
TEST(FindFreePlaces, OnANarrowShelfStandsWhatFitsWithItsMargins) {
  Table strip;
  strip.Put({-0.5F, -0.3F}, {0.5F, -0.077F}, kNone);
  strip.Put({-0.5F, 0.077F}, {0.5F, 0.3F}, kNone);
  EXPECT_FALSE(strip.Places({.size_m = {0.2F, 0.105F, 0.1F}, .margin_m = 0.02F}).empty());
  EXPECT_TRUE(strip.Places({.size_m = {0.2F, 0.119F, 0.1F}, .margin_m = 0.02F}).empty());
}

TEST(FindFreePlaces, OfWhatIsTooLargeThereIsNone) {
  EXPECT_TRUE(Table().Places({.size_m = {0.9F, 0.7F, 0.1F}}).empty());
  Table without_support;
  without_support.supports.clear();
  EXPECT_TRUE(without_support.Places({.size_m = {0.1F, 0.1F, 0.1F}}).empty());
}

}  // namespace
}  // namespace fovea
