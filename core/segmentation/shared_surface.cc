#include "core/segmentation/shared_surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "core/types/widest_registers.h"

namespace fovea {
namespace {

constexpr std::size_t kMaxSamples = 150;

}  // namespace

SegmentSurfaces::SegmentSurfaces(const VoxelGrid& grid, const Lists<int>& voxels,
                                 const SameSurface& same)
    : min_cosine_(static_cast<float>(std::cos(same.max_angle_deg * std::numbers::pi / 180))),
      max_offset_m_(static_cast<float>(same.max_offset_m)) {
  ranges_.reserve(voxels.size());
  const std::size_t most = std::min(grid.voxels.size(), kMaxSamples * voxels.size());
  for (std::vector<float>* column : {&voxels_.x, &voxels_.y, &voxels_.z, &voxels_.normal_x,
                                     &voxels_.normal_y, &voxels_.normal_z}) {
    column->reserve(most);
  }
  for (std::size_t segment = 0; segment < voxels.size(); ++segment) {
    const std::span<const int> all = voxels[segment];
    const std::size_t stride = all.size() / kMaxSamples + 1;
    const int begin = static_cast<int>(voxels_.x.size());
    for (std::size_t i = 0; i < all.size(); i += stride) {
      const Voxel& voxel = grid.voxels[all[i]];
      voxels_.x.push_back(voxel.mean.x());
      voxels_.y.push_back(voxel.mean.y());
      voxels_.z.push_back(voxel.mean.z());
      voxels_.normal_x.push_back(voxel.normal.x());
      voxels_.normal_y.push_back(voxel.normal.y());
      voxels_.normal_z.push_back(voxel.normal.z());
    }
    ranges_.push_back({begin, static_cast<int>(voxels_.x.size())});
  }
}

FOVEA_INLINE int SegmentSurfaces::CountOnSurface(Range of, Range other) const {
  const float *x = voxels_.x.data(), *y = voxels_.y.data(), *z = voxels_.z.data(),
              *nx = voxels_.normal_x.data(), *ny = voxels_.normal_y.data(),
              *nz = voxels_.normal_z.data();
  int count = 0;
  for (int v = of.begin; v < of.end; ++v) {
    int is_on_one = 0;
    for (int w = other.begin; w < other.end; ++w) {
      const float dx = x[v] - x[w], dy = y[v] - y[w], dz = z[v] - z[w];
      const float cosine = nx[v] * nx[w] + (ny[v] * ny[w] + nz[v] * nz[w]);
      const float from_v = nx[v] * dx + (ny[v] * dy + nz[v] * dz);
      const float from_w = nx[w] * dx + (ny[w] * dy + nz[w] * dz);
      is_on_one |= static_cast<int>(cosine >= min_cosine_) &
                   static_cast<int>(std::abs(from_v) <= max_offset_m_) &
                   static_cast<int>(std::abs(from_w) <= max_offset_m_);
    }
    count += is_on_one;
  }
  return count;
}

double SegmentSurfaces::ShareOnSurface(Range of, Range other) const {
  if (of.begin == of.end) return 0;
  int count = 0;
  RunInWidestRegisters([&] { count = CountOnSurface(of, other); });
  return static_cast<double>(count) / (of.end - of.begin);
}

bool SegmentSurfaces::AreOne(int a, int b, double min_share) const {
  return ShareOnSurface(ranges_[a], ranges_[b]) >= min_share &&
         ShareOnSurface(ranges_[b], ranges_[a]) >= min_share;
}

}  // namespace fovea
