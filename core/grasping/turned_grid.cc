#include "core/grasping/turned_grid.h"

#include <algorithm>
#include <cmath>

namespace fovea {

TurnedGrid Turned(const HandGrid& grid, const Eigen::Vector2f& closing, float half_across_m) {
  TurnedGrid turned;
  turned.closing = closing;
  turned.cell_m = grid.cell_m;
  turned.num_columns = grid.size;
  turned.num_rows =
      std::clamp(2 * static_cast<int>(std::ceil(half_across_m / grid.cell_m)), 2, grid.size);
  const std::size_t cells = static_cast<std::size_t>(turned.num_rows) * turned.num_columns;
  turned.target.assign(cells, HandGrid::kNothing);
  turned.other.assign(cells, HandGrid::kNothing);
  const Eigen::Vector2f step = turned.closing;  // in cells
  turned.first_row = turned.num_rows;
  for (int row = 0; row < turned.num_rows; ++row) {
    const Eigen::Vector3f start = turned.ToGrid(turned.AlongOf(0), turned.AcrossOf(row), 0);
    Eigen::Vector2f at = (start.head<2>().array() + grid.Half()) / grid.cell_m;
    const std::size_t offset = static_cast<std::size_t>(row) * turned.num_columns;
    for (int column = 0; column < turned.num_columns; ++column, at += step) {
      if (at.x() < 0 || at.y() < 0) continue;
      const int x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
      if (x >= grid.size || y >= grid.size) continue;
      const HandGrid::Column& source = grid.At(y, x);
      turned.target[offset + column] = source.target;
      turned.other[offset + column] = source.other;
      if (source.target <= HandGrid::kNothing) continue;
      turned.first_row = std::min(turned.first_row, row);
      turned.last_row = row;
    }
  }
  return turned;
}

void HighestOf(const TurnedGrid& turned, int first_row, int last_row, Strip& strip) {
  const auto columns = static_cast<std::size_t>(turned.num_columns);
  strip.target.assign(columns, HandGrid::kNothing);
  strip.other.assign(columns, HandGrid::kNothing);
  for (int row = std::max(0, first_row); row <= std::min(last_row, turned.num_rows - 1); ++row) {
    const float* target = turned.TargetRow(row);
    const float* other = turned.OtherRow(row);
    for (std::size_t c = 0; c < columns; ++c) {
      strip.target[c] = std::max(strip.target[c], target[c]);
      strip.other[c] = std::max(strip.other[c], other[c]);
    }
  }
}

}  // namespace fovea
