// What stands in the way of a hand around an object: heights against its approach.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/grasping/grasp_scene.h"
#include "core/grasping/solid_line.h"
#include "core/shape/level_frame.h"
#include "core/types/detections.h"

namespace fovea {

// A square grid of columns along the approach. Its frame has the third axis against the approach;
// heights are along that.
struct HandGrid {
  static constexpr float kNothing = -1e3F;  // height where there is nothing

  struct Column {
    float target = kNothing;  // of the object, filled down to what it stands on
    float other = kNothing;   // of everything else, as seen or completed, and of what the object
                              // stands on
  };

  LevelFrame frame;
  float cell_m = 0.004F;
  int size = 0;                 // cells along each side
  std::vector<Column> columns;  // row by row, y rises with the rows
  // What it stands on: a plane, in the frame.
  Eigen::Vector3f floor_normal = Eigen::Vector3f::UnitZ();
  float floor_offset_m = 0;  // normal · p + offset = 0

  // The height of the plane at a place; a huge one below a plane along which the hand moves in, and
  // everywhere if the hand would come through it.
  float FloorAt(float x, float y) const;
  // Whether a column's height is that huge one.
  static bool IsFloorInTheWay(float height) { return height >= -kNothing; }
  float Half() const { return cell_m * static_cast<float>(size) / 2; }
  // Coordinate of the middle of cell i along either axis.
  float MiddleOf(int i) const { return (static_cast<float>(i) + 0.5F) * cell_m - Half(); }
  // The cell of a coordinate; may lie outside.
  int CellAt(float coordinate) const { return CellAt(coordinate, Half(), cell_m); }
  static int CellAt(float coordinate, float half_m, float cell_m) {
    return static_cast<int>((coordinate + half_m) / cell_m + 1e4F) - 10000;
  }
  Column& At(int row, int column) { return columns[static_cast<std::size_t>(row * size + column)]; }
  const Column& At(int row, int column) const {
    return columns[static_cast<std::size_t>(row * size + column)];
  }
};

// Around object `target` of `objects`, for a hand that moves in along `approach` and reaches
// `reach_m` to each side. Cells grow with the object and its distance, so that a surface that faces
// the camera gives some points to each; at most 128 cells along a side. The second highest point of
// each cell counts: single ones may be noise. Cost: proportional to the part of the image that it
// covers, of which 60,000 pixels at most are looked at.
HandGrid BuildHandGrid(const GraspScene& scene, const std::vector<DetectedObject>& objects,
                       std::size_t target, const Eigen::Vector3f& approach, float reach_m);

}  // namespace fovea
