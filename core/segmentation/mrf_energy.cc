#include "core/segmentation/mrf_energy.h"

#include <algorithm>
#include <cmath>

#include "core/types/interruption.h"

namespace fovea {
namespace {

// The weight falls between voxels whose colours are farther apart than this, by a factor of e every
// scale; units of mean_color.h.
constexpr double kColorDistance = 12;
constexpr double kColorScale = 8;

}  // namespace

float PairwiseWeight(const Voxel& a, const Voxel& b, const MrfOptions& options) {
  const double groove = std::max(0.0F, -ConvexityDeg(a, b));
  const double angle = groove + options.step_weight * std::abs(StepDeg(a, b));
  return static_cast<float>(options.lambda * std::exp(-angle / options.concave_angle_deg));
}

float ColorShare(const MeanColor& a, const MeanColor& b, const MrfOptions& options) {
  const double beyond = std::max(0.0, a.DistanceTo(b) - kColorDistance);
  const double share = std::exp(-beyond / kColorScale);
  return static_cast<float>(options.color_floor + (1 - options.color_floor) * share);
}

PottsEnergy BuildEnergy(const VoxelGrid& grid, const cv::Mat& points,
                        const std::vector<MeanColor>& colors,
                        const std::vector<char>& is_background, const std::vector<Seed>& seeds,
                        const MrfOptions& options) {
  PottsEnergy energy;
  energy.num_nodes = static_cast<int>(grid.voxels.size());
  energy.choices = DataTerm(grid, points, is_background, seeds, options.data);
  LongLoop loop;
  for (const VoxelEdge& edge : grid.edges) {
    loop.Turn();
    if (is_background[edge.a] && is_background[edge.b]) continue;
    float weight = PairwiseWeight(grid.voxels[edge.a], grid.voxels[edge.b], options);
    if (!is_background[edge.a] && !is_background[edge.b]) {  // a support's colour says nothing
      weight *= ColorShare(colors[edge.a], colors[edge.b], options);
    }
    energy.edges.push_back({edge.a, edge.b, weight});
  }
  return energy;
}

}  // namespace fovea
