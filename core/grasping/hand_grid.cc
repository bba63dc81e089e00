#include "core/grasping/hand_grid.h"

#include <algorithm>
#include <cmath>

#include "core/grasping/grid_points.h"
#include "core/grasping/hollow.h"

namespace fovea {
namespace {

// Cosine of the way in to straight down; below it the hand moves along the floor, below its
// opposite it would come through it.
constexpr float kAlongFloor = 0.3F;

LevelFrame FrameAgainst(const Eigen::Vector3f& approach, const OrientedBox& box) {
  LevelFrame frame;
  Eigen::Vector3f x = box.rotation.col(0) - approach * approach.dot(box.rotation.col(0));
  if (x.norm() < 0.1F) x = box.rotation.col(1) - approach * approach.dot(box.rotation.col(1));
  frame.rotation.col(2) = -approach;
  frame.rotation.col(0) = x.normalized();
  frame.rotation.col(1) = frame.rotation.col(2).cross(frame.rotation.col(0));
  frame.origin = box.center;
  return frame;
}

void SetCells(const Eigen::Vector3f& half_extents, float distance_m, float focal_length_px,
              float reach_m, HandGrid& grid) {
  constexpr float kLeast_m = 0.003F;
  constexpr float kPixels = 2.2F;
  constexpr int kMostCells = 128;
  const float side = 2 * (half_extents.head<2>().norm() + reach_m);
  grid.cell_m = std::max({kLeast_m, kPixels * distance_m / focal_length_px, side / kMostCells});
  grid.size = std::min(kMostCells, static_cast<int>(std::ceil(side / grid.cell_m)));
  grid.columns.assign(static_cast<std::size_t>(grid.size) * grid.size, {});
}

struct CellRange {
  int first_row, last_row, first_column, last_column;
};

CellRange CellsUnder(const HandGrid& grid, const CompletedSolid& solid) {
  const Eigen::Vector3f& c = solid.Center();
  const Eigen::Vector3f& half = solid.HalfExtents();
  const auto cell = [&](float coordinate) {
    return std::clamp(grid.CellAt(coordinate), 0, grid.size - 1);
  };
  return {cell(c.y() - half.y()), cell(c.y() + half.y()), cell(c.x() - half.x()),
          cell(c.x() + half.x())};
}

// Calls fill(column, height) where the solid has a column.
template <typename Fill>
void ForEachColumn(HandGrid& grid, const CompletedSolid& solid, const Fill& fill) {
  const CellRange range = CellsUnder(grid, solid);
  Lines lines;
  for (int row = range.first_row; row <= range.last_row; ++row) {
    for (int column = range.first_column; column <= range.last_column; ++column) {
      lines.Add({grid.MiddleOf(column), grid.MiddleOf(row), 0}, Eigen::Vector3f::UnitZ());
    }
  }
  std::vector<Span> spans;
  solid.Along(lines, spans);
  auto span = spans.begin();
  for (int row = range.first_row; row <= range.last_row; ++row) {
    for (int column = range.first_column; column <= range.last_column; ++column, ++span) {
      if (!span->IsEmpty()) fill(grid.At(row, column), span->high);
    }
  }
}

// The others by what they were completed to.
void AddNeighbors(const std::vector<DetectedObject>& objects, std::size_t target, HandGrid& grid) {
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const float reach = objects[i].box.size_m.norm() / 2 + 1.5F * grid.Half();
    const Eigen::Vector3f center = grid.frame.FromCamera(objects[i].box.center);
    if (i == target || center.head<2>().norm() > reach) continue;
    const CompletedSolid solid(objects[i], grid.frame);
    if (!solid.IsKnown() || objects[i].shape.hollow) continue;
    ForEachColumn(grid, solid, [](HandGrid::Column& column, float height) {
      column.other = std::max(column.other, height);
    });
  }
}

void AddFloor(HandGrid& grid) {
  for (int row = 0; row < grid.size; ++row) {
    for (int column = 0; column < grid.size; ++column) {
      float& other = grid.At(row, column).other;
      other = std::max(other, grid.FloorAt(grid.MiddleOf(column), grid.MiddleOf(row)));
    }
  }
}

// Holes of up to two cells between cells of the object, along both axes.
void CloseHoles(HandGrid& grid) {
  const std::vector<HandGrid::Column> before = grid.columns;
  const auto height = [&](int row, int column) {
    return before[static_cast<std::size_t>(row * grid.size + column)].target;
  };
  for (int row = 2; row + 2 < grid.size; ++row) {
    for (int column = 2; column + 2 < grid.size; ++column) {
      float& target = grid.At(row, column).target;
      if (target > HandGrid::kNothing) continue;
      const float across = std::min(std::max(height(row, column - 1), height(row, column - 2)),
                                    std::max(height(row, column + 1), height(row, column + 2)));
      const float along = std::min(std::max(height(row - 1, column), height(row - 2, column)),
                                   std::max(height(row + 1, column), height(row + 2, column)));
      target = std::max(across, along);
    }
  }
}

}  // namespace

float HandGrid::FloorAt(float x, float y) const {
  const float level = floor_normal.x() * x + floor_normal.y() * y + floor_offset_m;
  if (floor_normal.z() >= kAlongFloor) return -level / floor_normal.z();
  if (floor_normal.z() <= -kAlongFloor) return -kNothing;
  return level < 0 ? -kNothing : kNothing;
}

HandGrid BuildHandGrid(const GraspScene& scene, const std::vector<DetectedObject>& objects,
                       std::size_t target, const Eigen::Vector3f& approach, float reach_m) {
  const DetectedObject& object = objects[target];
  HandGrid grid;
  grid.frame = FrameAgainst(approach, object.box);
  const CompletedSolid solid(object, grid.frame);
  const Eigen::Matrix3f grid_from_box = grid.frame.rotation.transpose() * object.box.rotation;
  const Eigen::Vector3f half = grid_from_box.cwiseAbs() * object.box.size_m / 2;
  SetCells(half, std::max(0.1F, object.box.center.z()),
           static_cast<float>(std::min(scene.intrinsics.fx_px, scene.intrinsics.fy_px)), reach_m,
           grid);
  grid.floor_normal = grid_from_box.col(2);
  grid.floor_offset_m = object.box.size_m.z() / 2;  // the frame's origin is the middle of the box
  AddPoints(scene, object, solid, half, grid);
  if (solid.IsKnown()) {
    ForEachColumn(grid, solid, [](HandGrid::Column& column, float height) {
      column.target = std::max(column.target, height);
    });
    if (object.shape.hollow) HollowOut(object, grid);
  } else {
    CloseHoles(grid);
  }
  AddNeighbors(objects, target, grid);
  AddFloor(grid);
  return grid;
}

}  // namespace fovea
