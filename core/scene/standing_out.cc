#include "core/scene/standing_out.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/segmentation/cell_index.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr double kBin = 6;            // of colours, in their units
constexpr double kUsualShare = 0.03;  // of the area of a support
constexpr std::size_t kUsualBins = 64;

std::vector<int> VoxelsOn(const Support& support, const VoxelGrid& grid,
                          const std::vector<char>& is_background, const SupportOptions& tolerance) {
  std::vector<int> on;
  on.reserve(grid.voxels.size());
  LongLoop loop;
  for (int v = 0; v < static_cast<int>(grid.voxels.size()); ++v) {
    loop.Turn();
    const Eigen::Vector3f& p = grid.voxels[v].mean;
    const float most = support.LargestShare() * SupportTolerance(p.z(), tolerance);
    if (is_background[v] == 0 || std::abs(support.surface.HeightOf(p)) > most) continue;
    if (support.footprint.Covers(p)) on.push_back(v);
  }
  return on;
}

// The colours that much of what is seen of a support has.
std::vector<Eigen::Vector3d> UsualColors(const VoxelGrid& grid, const std::vector<int>& on,
                                         const std::vector<MeanColor>& colors) {
  struct Sum {
    Eigen::Vector3d color = Eigen::Vector3d::Zero();
    double area = 0;
  };
  CellIndex index(kUsualBins);
  std::vector<Sum> bins;
  bins.reserve(kUsualBins);
  double total = 0;
  LongLoop loop;
  for (const int v : on) {
    loop.Turn();
    const Eigen::Vector3d color = colors[v].Mean();
    const Eigen::Vector3i bin = (color / kBin).array().floor().cast<int>();
    const double z = grid.voxels[v].mean.z();
    const double area = grid.voxels[v].num_points * z * z;
    const auto number =
        static_cast<std::size_t>(index.FindOrAdd(bin, static_cast<int>(bins.size())));
    if (number == bins.size()) bins.emplace_back();
    Sum& sum = bins[number];
    sum.color += area * color;
    sum.area += area;
    total += area;
  }
  std::vector<Eigen::Vector3d> usual;
  usual.reserve(static_cast<std::size_t>(1 / kUsualShare));
  for (const Sum& sum : bins) {
    if (sum.area >= kUsualShare * total) usual.emplace_back(sum.color / sum.area);
  }
  return usual;
}

bool IsOther(const Eigen::Vector3d& color, const std::vector<Eigen::Vector3d>& usual,
             double min_contrast) {
  return !usual.empty() && std::all_of(usual.begin(), usual.end(), [&](const auto& one) {
    return (color - one).squaredNorm() > min_contrast * min_contrast;
  });
}

}  // namespace

OnSupports FindStandingOut(const VoxelGrid& grid, const std::vector<MeanColor>& colors,
                           const std::vector<char>& is_background,
                           const std::vector<Support>& supports, const SupportOptions& tolerance,
                           double min_contrast) {
  const std::size_t count = grid.voxels.size();
  OnSupports found{std::vector<float>(count, std::numeric_limits<float>::quiet_NaN()),
                   std::vector<char>(count, 0)};
  for (const Support& support : supports) {
    const std::vector<int> on = VoxelsOn(support, grid, is_background, tolerance);
    const std::vector<Eigen::Vector3d> usual = UsualColors(grid, on, colors);
    LongLoop loop;
    for (const int v : on) {
      loop.Turn();
      found.height_m[v] = support.surface.HeightOf(grid.voxels[v].mean);
      if (IsOther(colors[v].Mean(), usual, min_contrast)) found.stands_out[v] = 1;
    }
  }
  return found;
}

}  // namespace fovea
