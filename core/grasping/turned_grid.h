// A hand's grid turned so that fingers close along its rows.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/grasping/hand_grid.h"

namespace fovea {

// Rows lie across the closing direction, columns along it; both in cells of the grid.
struct TurnedGrid {
  Eigen::Vector2f closing = Eigen::Vector2f::UnitX();  // unit, in the grid's frame
  float cell_m = 0;
  int num_rows = 0, num_columns = 0;
  // Row by row.
  std::vector<float> target, other;
  // The rows in which the object is.
  int first_row = 0, last_row = -1;

  float AcrossOf(int row) const { return (static_cast<float>(row) + 0.5F) * cell_m - HalfAcross(); }
  float AlongOf(float column) const { return (column + 0.5F) * cell_m - HalfAlong(); }
  float HalfAcross() const { return cell_m * static_cast<float>(num_rows) / 2; }
  float HalfAlong() const { return cell_m * static_cast<float>(num_columns) / 2; }
  // From places along and across, and heights, to the grid's frame.
  Eigen::Vector3f ToGrid(float along, float across, float height) const {
    return {closing.x() * along - closing.y() * across, closing.y() * along + closing.x() * across,
            height};
  }
  const float* TargetRow(int row) const {
    return &target[static_cast<std::size_t>(row) * num_columns];
  }
  const float* OtherRow(int row) const {
    return &other[static_cast<std::size_t>(row) * num_columns];
  }
};

// `half_across_m`: how far the rows reach from the middle to either side. Nearest cells; nothing
// beyond the grid. Takes some 3 ns a cell.
TurnedGrid Turned(const HandGrid& grid, const Eigen::Vector2f& closing, float half_across_m);

// The highest of some rows in each column.
struct Strip {
  std::vector<float> target, other;
};
void HighestOf(const TurnedGrid& turned, int first_row, int last_row, Strip& strip);

}  // namespace fovea
