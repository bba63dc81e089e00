#include "core/segmentation/mrf_energy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/types/interruption.h"
#include "core/types/too_complex.h"

namespace fovea {
namespace {

// Calls visit(voxel, point) for every point of a voxel that is not background.
template <typename Visit>
void ForEachPoint(const VoxelGrid& grid, const cv::Mat& points,
                  const std::vector<char>& is_background, Visit visit) {
  for (int row = 0; row < points.rows; ++row) {
    InterruptionPoint();
    const int* voxel_of_pixel = grid.voxel_of_pixel.ptr<int>(row);
    const cv::Vec3f* point = points.ptr<cv::Vec3f>(row);
    for (int col = 0; col < points.cols; ++col) {
      const int v = voxel_of_pixel[col];
      if (v < 0 || is_background[v]) continue;
      visit(v, Eigen::Vector3f(point[col][0], point[col][1], point[col][2]));
    }
  }
}

using Positions = Eigen::Array<float, Eigen::Dynamic, 3>;  // a row each

Positions PositionsOf(const std::vector<Seed>& seeds) {
  Positions positions(static_cast<Eigen::Index>(seeds.size()), 3);
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    positions.row(static_cast<Eigen::Index>(i)) = seeds[i].position.array().transpose();
  }
  return positions;
}

// To each position, summed in the order of squaredNorm().
auto SquaredDistances(const Positions& positions, const Eigen::Vector3f& from) {
  return (positions.col(0) - from.x()).square() +
         ((positions.col(1) - from.y()).square() + (positions.col(2) - from.z()).square());
}

// The seeds that may be the nearest to a point of the voxel: by the triangle inequality those not
// farther from its mean than the nearest one is, plus twice the voxel's radius.
std::vector<Eigen::Vector3f> NearSeeds(const Voxel& voxel, float radius, const Positions& seeds) {
  if (seeds.rows() == 0) return {};
  const Eigen::ArrayXf squared_distance = SquaredDistances(seeds, voxel.mean);
  // A little more for rounding, also where the voxel is a single point.
  const float limit = 1.00001F * std::sqrt(squared_distance.minCoeff()) + 2.01F * radius;
  std::vector<Eigen::Vector3f> near;
  for (Eigen::Index i = 0; i < seeds.rows(); ++i) {
    if (squared_distance[i] <= limit * limit) near.emplace_back(seeds.row(i).matrix());
  }
  return near;
}

// What the data term needs of a voxel's points.
struct PointStatistics {
  std::vector<float> variance;         // mean squared distance of the points to their mean
  std::vector<float> background_cost;  // Eq. 2 for the background label
};

// Eq. 6: −ln(α · min_c(1 − p(c|x))). The minimum is at the nearest seed.
float BackgroundCost(float squared_distance, const MrfOptions& options) {
  const double p_object = std::exp(-options.gamma_per_m2 * squared_distance);
  return static_cast<float>(
      -std::log(options.alpha * std::max(1 - p_object, options.min_probability)));
}

PointStatistics Collect(const VoxelGrid& grid, const cv::Mat& points,
                        const std::vector<char>& is_background, const std::vector<Seed>& seeds,
                        const MrfOptions& options) {
  const std::size_t num_voxels = grid.voxels.size();
  PointStatistics statistics{std::vector<float>(num_voxels), std::vector<float>(num_voxels)};
  std::vector<float> squared_radius(num_voxels);
  const auto share = [&](int v) { return 1.0F / static_cast<float>(grid.voxels[v].num_points); };
  ForEachPoint(grid, points, is_background, [&](int v, const Eigen::Vector3f& x) {
    const float squared_distance = (x - grid.voxels[v].mean).squaredNorm();
    statistics.variance[v] += share(v) * squared_distance;
    squared_radius[v] = std::max(squared_radius[v], squared_distance);
  });

  const Positions positions = PositionsOf(seeds);
  LongLoop loop;
  std::vector<std::vector<Eigen::Vector3f>> near_seeds(num_voxels);
  for (std::size_t v = 0; v < num_voxels; ++v) {
    loop.Turn();
    if (is_background[v]) continue;
    near_seeds[v] = NearSeeds(grid.voxels[v], std::sqrt(squared_radius[v]), positions);
  }
  ForEachPoint(grid, points, is_background, [&](int v, const Eigen::Vector3f& x) {
    float nearest = std::numeric_limits<float>::infinity();
    for (const Eigen::Vector3f& seed : near_seeds[v]) {
      nearest = std::min(nearest, (x - seed).squaredNorm());
    }
    statistics.background_cost[v] += share(v) * BackgroundCost(nearest, options);
  });
  return statistics;
}

constexpr std::size_t kMaxChoices = std::size_t{1} << 25U;

// The voxels that are not background.
struct Foreground {
  std::vector<int> voxels;
  Positions means;
  std::vector<float> variances;
};

Foreground CollectForeground(const VoxelGrid& grid, const std::vector<char>& is_background,
                             const std::vector<float>& variances) {
  Foreground foreground;
  for (int v = 0; v < static_cast<int>(is_background.size()); ++v) {
    if (!is_background[v]) foreground.voxels.push_back(v);
  }
  foreground.means.resize(static_cast<Eigen::Index>(foreground.voxels.size()), 3);
  for (const int v : foreground.voxels) {
    const auto row = static_cast<Eigen::Index>(foreground.variances.size());
    foreground.means.row(row) = grid.voxels[v].mean.array().transpose();
    foreground.variances.push_back(variances[v]);
  }
  return foreground;
}

// Eq. 2 and 5 in closed form: the mean of γ‖x − x₀‖² over a voxel's points is
// γ(‖mean − x₀‖² + variance).
std::vector<PottsEnergy::Choice> ChoicesOfSeed(const Foreground& foreground, const Seed& seed,
                                               const MrfOptions& options) {
  const float max_cost = static_cast<float>(-std::log(options.min_probability));
  const float max_squared_distance = static_cast<float>(options.reach_m * options.reach_m);
  const Eigen::ArrayXf squared_distances = SquaredDistances(foreground.means, seed.position);
  std::vector<PottsEnergy::Choice> choices;
  for (std::size_t i = 0; i < foreground.voxels.size(); ++i) {
    const float squared_distance = squared_distances[static_cast<Eigen::Index>(i)];
    if (squared_distance > max_squared_distance) continue;
    const double squared = squared_distance + foreground.variances[i];
    const auto cost = static_cast<float>(options.gamma_per_m2 * squared);
    if (cost < max_cost) choices.push_back({foreground.voxels[i], cost});
  }
  return choices;
}

}  // namespace

float PairwiseWeight(const Voxel& a, const Voxel& b, const MrfOptions& options) {
  if (options.concave_angle_deg > 0) {
    const double groove = std::max(0.0F, -ConvexityDeg(a, b));
    const double step = options.step_weight > 0 ? std::abs(StepDeg(a, b)) : 0;
    const double angle = groove + options.step_weight * step;
    return static_cast<float>(options.lambda * std::exp(-angle / options.concave_angle_deg));
  }
  const Eigen::Vector3f difference = a.normal - b.normal;
  const bool convex = difference.dot(a.mean - b.mean) > 0;  // Eq. 8
  const double distance = difference.norm() + options.normal_constant;
  return static_cast<float>(options.lambda / distance * ((convex ? 1 : 0) + options.epsilon));
}

float ColorShare(const MeanColor& a, const MeanColor& b, const MrfOptions& options) {
  const double beyond = std::max(0.0, a.DistanceTo(b) - options.color_distance);
  const double share = std::exp(-beyond / options.color_scale);
  return static_cast<float>(options.color_floor + (1 - options.color_floor) * share);
}

PottsEnergy BuildEnergy(const VoxelGrid& grid, const cv::Mat& points,
                        const std::vector<MeanColor>& colors,
                        const std::vector<char>& is_background, const std::vector<Seed>& seeds,
                        const MrfOptions& options) {
  const PointStatistics statistics = Collect(grid, points, is_background, seeds, options);
  PottsEnergy energy;
  energy.num_nodes = static_cast<int>(grid.voxels.size());
  std::vector<PottsEnergy::Choice>& background = energy.choices.emplace_back();
  InterruptionPoint();
  for (int v = 0; v < energy.num_nodes; ++v) {
    background.push_back({v, statistics.background_cost[v]});
  }
  const Foreground foreground = CollectForeground(grid, is_background, statistics.variance);
  std::size_t num_choices = 0;
  for (const Seed& seed : seeds) {
    InterruptionPoint();
    energy.choices.push_back(ChoicesOfSeed(foreground, seed, options));
    num_choices += energy.choices.back().size();
    if (num_choices > kMaxChoices) {
      throw TooComplex(
          "mrf: too many voxels within reach of too many seeds; raise mrf.gamma_per_m2 or "
          "voxels.size_m");
    }
  }
  LongLoop loop;
  for (const VoxelEdge& edge : grid.edges) {
    loop.Turn();
    if (is_background[edge.a] && is_background[edge.b]) continue;
    float weight = PairwiseWeight(grid.voxels[edge.a], grid.voxels[edge.b], options);
    const bool between_objects = !is_background[edge.a] && !is_background[edge.b];
    if (options.color_floor < 1 && between_objects) {
      weight *= ColorShare(colors[edge.a], colors[edge.b], options);
    }
    energy.edges.push_back({edge.a, edge.b, weight});
  }
  return energy;
}

}  // namespace fovea
