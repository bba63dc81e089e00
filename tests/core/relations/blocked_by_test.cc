#include "core/relations/blocked_by.h"

#include <gtest/gtest.h>

namespace fovea {
namespace {

std::vector<DetectedObject> Stack(const std::vector<std::vector<int>>& stands_on) {
  std::vector<DetectedObject> objects(stands_on.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    objects[i].label = static_cast<int>(i) + 1;
    objects[i].stands_on = stands_on[i];
  }
  BlockByWhatStandsOn(objects);
  return objects;
}

TEST(BlockByWhatStandsOn, IsAllAboveTheTopmostFirst) {
  const auto objects = Stack({{0}, {1}, {2}, {0}});
  EXPECT_EQ(objects[0].blocked_by, (std::vector<int>{3, 2}));
  EXPECT_EQ(objects[1].blocked_by, std::vector<int>{3});
  EXPECT_TRUE(objects[2].blocked_by.empty());
  EXPECT_TRUE(objects[3].blocked_by.empty());
}

TEST(BlockByWhatStandsOn, EndsWhereThingsCarryEachOther) {
  const auto objects = Stack({{2}, {1}});
  EXPECT_EQ(objects[0].blocked_by, std::vector<int>{2});
  EXPECT_EQ(objects[1].blocked_by, std::vector<int>{1});
}

TEST(BlockByWhatStandsOn, WhatRestsOnTwoThingsGoesBeforeBoth) {
  // A tray, on it a book that leans against a box, and the box.
  auto objects = Stack({{3}, {3}, {0}});
  objects[0].leans_on = {2};
  BlockByWhatStandsOn(objects);
  EXPECT_EQ(objects[2].blocked_by, (std::vector<int>{1, 2}));
  EXPECT_EQ(objects[1].blocked_by, std::vector<int>{1});
  // The same with the labels of book and box swapped.
  objects = Stack({{3}, {3}, {0}});
  objects[1].leans_on = {1};
  BlockByWhatStandsOn(objects);
  EXPECT_EQ(objects[2].blocked_by, (std::vector<int>{2, 1}));
}

}  // namespace
}  // namespace fovea
