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

std::vector<Seed> SeedsAbove(const std::vector<Support>& supports, const std::vector<Seed>& seeds,
                             const SupportOptions& options, std::vector<RemovedSeed>& removed) {
  std::vector<Seed> above;
  for (const Seed& seed : seeds) {
    if (MayBeObject(supports, seed.position, options)) {
      above.push_back(seed);
    } else {
      removed.push_back({seed.pixel, seed.source, RemovedSeed::Reason::kOnSupport});
    }
  }
  return above;
}

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
