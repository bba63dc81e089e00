#include "core/paper/surface_energy.h"

#include "core/paper/background_costs.h"
#include "core/types/interruption.h"

namespace fovea::paper {

float SurfaceWeight(const Voxel& a, const Voxel& b, const SurfaceEnergyOptions& options) {
  const Eigen::Vector3f difference = a.normal - b.normal;
  const bool convex = difference.dot(a.mean - b.mean) > 0;  // Eq. 8
  const double distance = difference.norm() + options.normal_constant;
  return static_cast<float>(options.lambda / distance * ((convex ? 1 : 0) + options.epsilon));
}

PottsEnergy BuildSurfaceEnergy(const VoxelGrid& grid, const cv::Mat& points,
                               const std::vector<char>& is_background, const cv::Mat& on_support,
                               const std::vector<Seed>& seeds,
                               const SurfaceEnergyOptions& options) {
  PottsEnergy energy;
  energy.num_nodes = static_cast<int>(grid.voxels.size());
  energy.choices = DataTerm(grid, points, is_background, seeds, options.data);
  const std::vector<float> costs =
      BackgroundCosts(grid, points, is_background, on_support, seeds, options.data);
  for (PottsEnergy::Choice& choice : energy.choices[0]) choice.cost = costs[choice.node];
  LongLoop loop;
  for (const VoxelEdge& edge : grid.edges) {
    loop.Turn();
    if (is_background[edge.a] && is_background[edge.b]) continue;
    energy.edges.push_back(
        {edge.a, edge.b, SurfaceWeight(grid.voxels[edge.a], grid.voxels[edge.b], options)});
  }
  return energy;
}

}  // namespace fovea::paper
