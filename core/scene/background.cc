#include "core/scene/background.h"

#include <algorithm>

#include "core/types/interruption.h"

namespace fovea {
namespace {

bool MayBeObject(const std::vector<Support>& supports, const Eigen::Vector3f& point,
                 const SupportOptions& options) {
  return supports.empty() || SupportBelow(supports, point, options);
}

}  // namespace

std::vector<char> FindBackground(const VoxelGrid& grid, const std::vector<Support>& supports,
                                 const SupportOptions& options, const CameraIntrinsics& intrinsics,
                                 const RegionOptions& region) {
  std::vector<char> is_background(grid.voxels.size());
  LongLoop loop;
  std::transform(grid.voxels.begin(), grid.voxels.end(), is_background.begin(),
                 [&](const Voxel& voxel) {
                   loop.Turn();
                   return !MayBeObject(supports, voxel.mean, options) ||
                          !IsInRegion(voxel.mean, intrinsics, region);
                 });
  return is_background;
}

}  // namespace fovea
