#include "core/segmentation/mrf_energy.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/types/interruption.h"

namespace fovea {
namespace {

// The weight falls between voxels whose colours are farther apart than this, by a factor of e every
// scale; units of mean_color.h.
constexpr double kColorDistance = 12;
constexpr double kColorScale = 8;

// Of lambda: cutting between voxels of one cluster costs at least as much.
constexpr double kMinShareOfCluster = 0.6;

// What cutting between neighbouring voxels costs, unless both are background.
std::vector<PottsEnergy::Edge> WeighEdges(const VoxelGrid& grid,
                                          const std::vector<MeanColor>& colors,
                                          const std::vector<char>& is_background,
                                          const MrfOptions& options) {
  std::vector<PottsEnergy::Edge> edges;
  edges.reserve(grid.edges.size());
  LongLoop loop;
  for (const VoxelEdge& edge : grid.edges) {
    loop.Turn();
    if (is_background[edge.a] && is_background[edge.b]) continue;
    float weight = PairwiseWeight(grid.voxels[edge.a], grid.voxels[edge.b], options);
    if (!is_background[edge.a] && !is_background[edge.b]) {  // a support's colour says nothing
      weight *= ColorShare(colors[edge.a], colors[edge.b], options);
    }
    edges.push_back({edge.a, edge.b, weight});
  }
  return edges;
}

// The points of a voxel count as its mean.
Sites SitesOf(const VoxelGrid& grid, const Clusters& clusters) {
  const std::size_t count = clusters.sizes.size();
  Sites sites{std::vector<Eigen::Vector3f>(count, Eigen::Vector3f::Zero()),
              std::vector<float>(count, 0),
              {clusters.sizes.begin(), clusters.sizes.end()}};
  const auto for_each_voxel = [&](const auto& visit) {
    LongLoop loop;
    for (std::size_t v = 0; v < grid.voxels.size(); ++v) {
      loop.Turn();
      if (const int site = clusters.of_node[v]; site >= 0) visit(site, grid.voxels[v].mean);
    }
  };
  for_each_voxel([&](int site, const Eigen::Vector3f& mean) {
    sites.means[site] += mean / sites.weights[site];
  });
  for_each_voxel([&](int site, const Eigen::Vector3f& mean) {
    sites.variances_m2[site] += (mean - sites.means[site]).squaredNorm() / sites.weights[site];
  });
  return sites;
}

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

ClusteredEnergy BuildEnergy(const VoxelGrid& grid, const std::vector<MeanColor>& colors,
                            const std::vector<char>& is_background, const std::vector<Seed>& seeds,
                            const MrfOptions& options) {
  const std::vector<PottsEnergy::Edge> edges = WeighEdges(grid, colors, is_background, options);
  Clusters clusters = FindClusters(edges, is_background, options.cluster_voxels,
                                   static_cast<float>(kMinShareOfCluster * options.lambda));
  PottsEnergy energy;
  energy.num_nodes = static_cast<int>(clusters.sizes.size());
  energy.choices = DataTerm(SitesOf(grid, clusters), seeds, options.data);
  const std::vector<float> outwards = WeightsOutwards(clusters, edges);
  for (PottsEnergy::Choice& choice : energy.choices[0]) choice.cost -= outwards[choice.node];
  energy.edges = EdgesBetween(clusters, edges);
  return {std::move(energy), std::move(clusters)};
}

}  // namespace fovea
