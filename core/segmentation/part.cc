#include "core/segmentation/part.h"

#include "core/segmentation/labels.h"
#include "core/types/interruption.h"
#include "core/types/level_axes.h"

namespace fovea {

void Part::Add(const Part& other) {
  num_voxels += other.num_voxels;
  z_sum_m += other.z_sum_m;
  area_m2 += other.area_m2;
  extent.extend(other.extent);
  color.Add(other.color);
}

std::vector<Part> CollectParts(const VoxelGrid& grid, const std::vector<int>& labels,
                               const std::vector<MeanColor>& colors,
                               const CameraIntrinsics& intrinsics, const Eigen::Vector3f& up) {
  Eigen::Matrix3f axes;
  axes << LevelAxesAlongView(up), up.transpose();
  std::vector<Part> parts(CountLabels(labels) + 1);
  LongLoop loop;
  for (std::size_t v = 0; v < labels.size(); ++v) {
    loop.Turn();
    if (labels[v] == 0) continue;
    const Voxel& voxel = grid.voxels[v];
    const double z = voxel.mean.z();
    parts[labels[v]].Add(
        {.num_voxels = 1,
         .z_sum_m = z,
         .area_m2 = voxel.num_points * z * z / (intrinsics.fx_px * intrinsics.fy_px),
         .extent = Eigen::AlignedBox3f(Eigen::Vector3f(axes * voxel.mean)),
         .color = colors[v]});
  }
  return parts;
}

}  // namespace fovea
