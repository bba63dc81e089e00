// The inside of cups, in the grid that a hand moves in along.
#include "core/grasping/hollow.h"

#include <gtest/gtest.h>

#include "tests/core/shape/things_on_floor.h"

namespace fovea {
namespace {

HandGrid GridOverCup(double diameter_m, DetectedObject& cup) {
  const ThingsOnFloor scene = CompleteThings(
      {Thing(scenes::ShapeKind::kCup, {diameter_m, diameter_m, 0.1}, {0, 0}, 0, 0, 0.004)}, 60);
  const Detections& found = scene.detections;
  cup = found.objects[0];
  return BuildHandGrid(
      {scene.points, found.labels, scene.frame.intrinsics, -found.gravity.direction}, found.objects,
      0, found.gravity.direction, 0.1F);
}

TEST(HollowOut, LeavesTheRimAndEmptiesTheMiddle) {
  for (const double diameter_m : {0.07, 0.075, 0.08, 0.085, 0.09}) {
    DetectedObject cup;
    const HandGrid grid = GridOverCup(diameter_m, cup);
    ASSERT_TRUE(cup.shape.hollow) << diameter_m;
    const float radius = cup.shape.radius_m, top = cup.box.size_m.z() / 2;
    int on_rim = 0;
    for (int row = 0; row < grid.size; ++row) {
      for (int column = 0; column < grid.size; ++column) {
        const float from_axis = std::hypot(grid.MiddleOf(row), grid.MiddleOf(column));
        const float height = grid.At(row, column).target;
        if (from_axis > radius - 0.004F && from_axis < radius - 0.0005F) {
          ++on_rim;
          EXPECT_GT(height, top - 0.002F) << diameter_m << " " << from_axis;
        }
        if (from_axis < radius / 2) {
          EXPECT_LT(height, top - 0.02F) << diameter_m;
        }
      }
    }
    EXPECT_GT(on_rim, 20);
  }
}

}  // namespace
}  // namespace fovea
