#include "core/scene/background.h"

#include <algorithm>

#include "core/types/interruption.h"

namespace fovea {
namespace {

bool MayBeObject(const std::vector<Support>& supports, const Eigen::Vector3f& point,
                 const SupportOptions& options) {
  return supports.empty() || SupportBelow(supports, point, options);
}

// One entry a voxel: 1 where `is` is true of it.
template <typename IsTrue>
std::vector<char> OfVoxels(const VoxelGrid& grid, const IsTrue& is) {
  std::vector<char> values(grid.voxels.size());
  LongLoop loop;
  std::transform(grid.voxels.begin(), grid.voxels.end(), values.begin(), [&](const Voxel& voxel) {
    loop.Turn();
    return is(voxel.mean);
  });
  return values;
}

}  // namespace

std::vector<char> FindBackground(const VoxelGrid& grid, const std::vector<Support>& supports,
                                 const SupportOptions& options, const CameraIntrinsics& intrinsics,
                                 const RegionOptions& region) {
  return OfVoxels(grid, [&](const Eigen::Vector3f& mean) {
    return !MayBeObject(supports, mean, options) || !IsInRegion(mean, intrinsics, region);
  });
}

std::vector<char> FindHiddenByRegion(const VoxelGrid& grid, const std::vector<Support>& supports,
                                     const SupportOptions& options,
                                     const CameraIntrinsics& intrinsics,
                                     const RegionOptions& region) {
  if (region == RegionOptions()) return {};
  return OfVoxels(grid, [&](const Eigen::Vector3f& mean) {
    return !IsInRegion(mean, intrinsics, region) && MayBeObject(supports, mean, options);
  });
}

std::vector<char> FindCutByRegion(const VoxelGrid& grid, const std::vector<int>& objects,
                                  std::size_t num_objects, const std::vector<char>& hidden) {
  if (hidden.empty()) return {};
  std::vector<char> is_cut(num_objects, 0);
  const auto cut = [&](int voxel, int beside) {
    if (objects[voxel] > 0 && hidden[beside] != 0) is_cut[objects[voxel] - 1] = 1;
  };
  LongLoop loop;
  for (const VoxelEdge& edge : grid.edges) {
    loop.Turn();
    cut(edge.a, edge.b);
    cut(edge.b, edge.a);
  }
  return is_cut;
}

}  // namespace fovea
