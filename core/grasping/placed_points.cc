#include "core/grasping/placed_points.h"

#include "core/types/widest_registers.h"

namespace fovea {

void PlaceIn(const HandGrid& grid, PlacedPoints& all) {
  constexpr float kOnFloor_m = 0.008F, kNoisePer_m = 0.003F;  // metres, of the distance squared
  RunInWidestRegisters([&] {
    PlacedPoints points = all;  // of its own, as all that the loop reads is
    const Eigen::Matrix3f axes = grid.frame.rotation.transpose();
    const Eigen::Vector3f origin = axes * grid.frame.origin, normal = grid.floor_normal;
    const float half_m = grid.Half(), cell_m = grid.cell_m, offset_m = grid.floor_offset_m;
    const int size = grid.size;
    for (int i = 0; i < PlacedPoints::kNum; ++i) {
      const float x = points.x[i], y = points.y[i], z = points.z[i];
      const bool is_seen = z == z;
      const float u = axes(0, 0) * x + (axes(0, 1) * y + axes(0, 2) * z) - origin[0];
      const float v = axes(1, 0) * x + (axes(1, 1) * y + axes(1, 2) * z) - origin[1];
      const float w = axes(2, 0) * x + (axes(2, 1) * y + axes(2, 2) * z) - origin[2];
      const int column = HandGrid::CellAt(is_seen ? u : 0, half_m, cell_m);
      const int row = HandGrid::CellAt(is_seen ? v : 0, half_m, cell_m);
      const float noise = kNoisePer_m * z * z;
      const float above = normal[0] * u + (normal[1] * v + normal[2] * w) + offset_m;
      const bool is_floor = (points.label[i] == 0) & (above < kOnFloor_m + noise);
      const bool is_in = is_seen & (column >= 0) & (row >= 0) & (column < size) & (row < size);
      points.cell[i] = (is_in & !is_floor) ? row * size + column : -1;
      points.noise_m[i] = noise;
      points.x[i] = u, points.y[i] = v, points.z[i] = w;
    }
    all = points;
  });
}

}  // namespace fovea
