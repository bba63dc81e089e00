#include "core/paper/surface_energy.h"

#include "core/paper/background_costs.h"
#include "core/segmentation/foreground.h"
#include "core/segmentation/points_of_voxels.h"
#include "core/types/interruption.h"

namespace fovea::paper {
namespace {

// The voxels that are not background, and their points.
Sites SitesOf(const VoxelGrid& grid, const Foreground& foreground, const cv::Mat& points,
              const std::vector<char>& is_background) {
  std::vector<float> variances(grid.voxels.size());
  ForEachPoint(grid, points, is_background, [&](int v, const Eigen::Vector3f& x, cv::Point) {
    const float share = 1.0F / static_cast<float>(grid.voxels[v].num_points);
    variances[v] += share * (x - grid.voxels[v].mean).squaredNorm();
  });
  Sites sites{foreground.means, {}, std::vector<float>(foreground.voxels.size(), 1)};
  for (const int v : foreground.voxels) sites.variances_m2.push_back(variances[v]);
  return sites;
}

}  // namespace

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
  const Foreground foreground = CollectForeground(grid, is_background);
  energy.choices = DataTerm(SitesOf(grid, foreground, points, is_background), seeds, options.data);
  for (std::size_t label = 1; label < energy.choices.size(); ++label) {
    for (PottsEnergy::Choice& choice : energy.choices[label]) {
      choice.node = foreground.voxels[choice.node];
    }
  }
  const std::vector<float> costs =
      BackgroundCosts(grid, points, is_background, on_support, seeds, options.data);
  energy.choices.Begin(0);
  for (int v = 0; v < energy.num_nodes; ++v) energy.choices.Add({v, costs[v]});
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
