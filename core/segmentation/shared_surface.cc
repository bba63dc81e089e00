#include "core/segmentation/shared_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fovea {
namespace {

constexpr std::size_t kMaxSamples = 150;

// At most kMaxSamples of the voxels, evenly.
std::vector<int> Sample(std::span<const int> voxels) {
  const std::size_t stride = voxels.size() / kMaxSamples + 1;
  std::vector<int> sample;
  sample.reserve(kMaxSamples);
  for (std::size_t i = 0; i < voxels.size(); i += stride) sample.push_back(voxels[i]);
  return sample;
}

bool OnOneSurface(const Voxel& a, const Voxel& b, double min_cosine, double max_offset_m) {
  if (a.normal.dot(b.normal) < min_cosine) return false;
  const Eigen::Vector3f step = a.mean - b.mean;
  return std::abs(a.normal.dot(step)) <= max_offset_m &&
         std::abs(b.normal.dot(step)) <= max_offset_m;
}

// Share of the voxels of `a` that lie on a surface of `b`.
double ShareOnSurface(const VoxelGrid& grid, const std::vector<int>& a, const std::vector<int>& b,
                      const SameSurface& same) {
  const double min_cosine = std::cos(same.max_angle_deg * std::numbers::pi / 180);
  const auto shared = std::count_if(a.begin(), a.end(), [&](int v) {
    return std::any_of(b.begin(), b.end(), [&](int w) {
      return OnOneSurface(grid.voxels[v], grid.voxels[w], min_cosine, same.max_offset_m);
    });
  });
  return a.empty() ? 0 : static_cast<double>(shared) / static_cast<double>(a.size());
}

}  // namespace

double SharedSurface(const VoxelGrid& grid, std::span<const int> a, std::span<const int> b,
                     const SameSurface& same) {
  const std::vector<int> of_a = Sample(a), of_b = Sample(b);
  return std::min(ShareOnSurface(grid, of_a, of_b, same), ShareOnSurface(grid, of_b, of_a, same));
}

}  // namespace fovea
