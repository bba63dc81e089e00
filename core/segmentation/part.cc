#include "core/segmentation/part.h"

#include "core/segmentation/labels.h"

namespace fovea {
namespace {

// Unit vectors as rows: level across the view, level along it (to the upper border of the image
// where the camera looks nearly straight down or up), and up.
Eigen::Matrix3f ViewAxes(const Eigen::Vector3f& up) {
  constexpr float kMinLevel = 0.3F;  // of the optical axis
  const auto level = [&up](const Eigen::Vector3f& way) { return way - up * up.dot(way); };
  Eigen::Vector3f away = level(Eigen::Vector3f::UnitZ());
  if (away.norm() < kMinLevel) away = level(-Eigen::Vector3f::UnitY());
  away.normalize();
  Eigen::Matrix3f axes;
  axes << away.cross(up).transpose(), away.transpose(), up.transpose();
  return axes;
}

}  // namespace

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
  const Eigen::Matrix3f axes = ViewAxes(up);
  std::vector<Part> parts(CountLabels(labels) + 1);
  for (std::size_t v = 0; v < labels.size(); ++v) {
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
