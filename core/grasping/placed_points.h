// Points in the cells of a hand's grid, many at once.
#pragma once

#include <array>

#include "core/grasping/hand_grid.h"

namespace fovea {

// Points of a row of the image.
struct PlacedPoints {
  static constexpr int kNum = 64;
  template <typename T>
  using Each = std::array<T, kNum>;

  Each<float> x, y, z;  // in the camera's frame, then in the grid's
  Each<float> noise_m;
  Each<int> label;
  Each<int> cell;  // -1 outside of the grid, not measured, or on what the object stands on
};

// Sets all else from where the camera sees them and their labels, of all kNum.
void PlaceIn(const HandGrid& grid, PlacedPoints& points);

}  // namespace fovea
