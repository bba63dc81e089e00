#include "core/segmentation/data_term.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/segmentation/neighborhoods.h"
#include "core/types/interruption.h"
#include "core/types/too_complex.h"

namespace fovea {
namespace {

// Calls visit(voxel, point, pixel) for every point of a voxel that is not background.
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
      visit(v, Eigen::Vector3f(point[col][0], point[col][1], point[col][2]), cv::Point(col, row));
    }
  }
}

// The voxels that are not background.
struct Foreground {
  std::vector<int> voxels;
  std::vector<Eigen::Vector3f> means;
};

Foreground CollectForeground(const VoxelGrid& grid, const std::vector<char>& is_background) {
  Foreground foreground;
  for (int v = 0; v < static_cast<int>(is_background.size()); ++v) {
    if (is_background[v]) continue;
    foreground.voxels.push_back(v);
    foreground.means.push_back(grid.voxels[v].mean);
  }
  return foreground;
}

using Positions = Eigen::Array<float, Eigen::Dynamic, 3>;  // a row each

Positions Chosen(const std::vector<Eigen::Vector3f>& positions, const std::vector<int>& indices) {
  Positions chosen(static_cast<Eigen::Index>(indices.size()), 3);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    chosen.row(static_cast<Eigen::Index>(i)) = positions[indices[i]].array().transpose();
  }
  return chosen;
}

std::vector<Eigen::Vector3f> PositionsOf(const std::vector<Seed>& seeds) {
  std::vector<Eigen::Vector3f> positions;
  positions.reserve(seeds.size());
  for (const Seed& seed : seeds) positions.push_back(seed.position);
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

// The same of each voxel, without those from which no point of it is within `reach_m`.
std::vector<std::vector<Eigen::Vector3f>> FindNearSeeds(const VoxelGrid& grid,
                                                        const Foreground& foreground,
                                                        const std::vector<float>& squared_radius,
                                                        const std::vector<Seed>& seeds,
                                                        float reach_m) {
  std::vector<std::vector<Eigen::Vector3f>> near_seeds(grid.voxels.size());
  if (foreground.voxels.empty()) return near_seeds;
  const std::vector<Eigen::Vector3f> positions = PositionsOf(seeds);
  const float max_radius = std::sqrt(std::ranges::max(squared_radius));
  LongLoop loop;
  ForEachNeighborhood(foreground.means, positions, reach_m + max_radius,
                      [&](const std::vector<int>& members, const std::vector<int>& near) {
                        const Positions around = Chosen(positions, near);
                        for (const int i : members) {
                          loop.Turn();
                          const int v = foreground.voxels[i];
                          near_seeds[v] =
                              NearSeeds(grid.voxels[v], std::sqrt(squared_radius[v]), around);
                        }
                      });
  return near_seeds;
}

// What the data term needs of a voxel's points.
struct PointStatistics {
  std::vector<float> variance;         // mean squared distance of the points to their mean
  std::vector<float> background_cost;  // Eq. 2 for the background label
};

// Eq. 6: −ln(α · min_c(1 − p(c|x))). The minimum is at the nearest seed.
float BackgroundCost(float squared_distance, const DataTermOptions& options) {
  const double p_object = std::exp(-options.gamma_per_m2 * squared_distance);
  return static_cast<float>(
      -std::log(options.alpha * std::max(1 - p_object, options.min_probability)));
}

// From where on Eq. 5 leaves nothing of Eq. 6: less than half of the last bit of one.
float BackgroundReach(const DataTermOptions& options) {
  return static_cast<float>(std::sqrt(38 / options.gamma_per_m2));
}

PointStatistics Collect(const VoxelGrid& grid, const cv::Mat& points,
                        const std::vector<char>& is_background, const Foreground& foreground,
                        const cv::Mat& on_support, const std::vector<Seed>& seeds,
                        const DataTermOptions& options) {
  const std::size_t num_voxels = grid.voxels.size();
  PointStatistics statistics{std::vector<float>(num_voxels), std::vector<float>(num_voxels)};
  std::vector<float> squared_radius(num_voxels);
  const auto share = [&](int v) { return 1.0F / static_cast<float>(grid.voxels[v].num_points); };
  ForEachPoint(grid, points, is_background, [&](int v, const Eigen::Vector3f& x, cv::Point) {
    const float squared_distance = (x - grid.voxels[v].mean).squaredNorm();
    statistics.variance[v] += share(v) * squared_distance;
    squared_radius[v] = std::max(squared_radius[v], squared_distance);
  });

  const std::vector<std::vector<Eigen::Vector3f>> near_seeds =
      FindNearSeeds(grid, foreground, squared_radius, seeds, BackgroundReach(options));
  ForEachPoint(grid, points, is_background, [&](int v, const Eigen::Vector3f& x, cv::Point at) {
    if (!on_support.empty() && on_support.at<std::uint8_t>(at) != 0) return;  // -ln 1
    float nearest = std::numeric_limits<float>::infinity();
    for (const Eigen::Vector3f& seed : near_seeds[v]) {
      nearest = std::min(nearest, (x - seed).squaredNorm());
    }
    statistics.background_cost[v] += share(v) * BackgroundCost(nearest, options);
  });
  return statistics;
}

constexpr std::size_t kMaxChoices = std::size_t{1} << 25U;

void RequireFewChoices(std::size_t num_choices) {
  if (num_choices <= kMaxChoices) return;
  throw TooComplex(
      "mrf: too many voxels within reach of too many seeds; raise mrf.gamma_per_m2 or "
      "voxels.size_m");
}

float MaxCost(const DataTermOptions& options) {
  return static_cast<float>(-std::log(options.min_probability));
}

// From where on no voxel has the hypothesis of a seed for a choice.
float ChoiceReach(const DataTermOptions& options) {
  return static_cast<float>(
      std::min(options.reach_m, std::sqrt(MaxCost(options) / options.gamma_per_m2)));
}

// Eq. 2 and 5 in closed form: the mean of γ‖x − x₀‖² over a voxel's points is
// γ(‖mean − x₀‖² + variance).
// `near`: of the foreground, ascending, with their means.
std::vector<PottsEnergy::Choice> ChoicesOfSeed(const Foreground& foreground,
                                               const std::vector<float>& variance,
                                               const std::vector<int>& near, const Positions& means,
                                               const Seed& seed, const DataTermOptions& options) {
  const float max_cost = MaxCost(options);
  const float max_squared_distance = static_cast<float>(options.reach_m * options.reach_m);
  const Eigen::ArrayXf squared_distances = SquaredDistances(means, seed.position);
  std::vector<PottsEnergy::Choice> choices;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const float squared_distance = squared_distances[static_cast<Eigen::Index>(i)];
    if (squared_distance > max_squared_distance) continue;
    const int v = foreground.voxels[near[i]];
    const double squared = squared_distance + variance[v];
    const auto cost = static_cast<float>(options.gamma_per_m2 * squared);
    if (cost < max_cost) choices.push_back({v, cost});
  }
  return choices;
}

}  // namespace

std::vector<std::vector<PottsEnergy::Choice>> DataTerm(const VoxelGrid& grid, const cv::Mat& points,
                                                       const std::vector<char>& is_background,
                                                       const cv::Mat& on_support,
                                                       const std::vector<Seed>& seeds,
                                                       const DataTermOptions& options) {
  const Foreground foreground = CollectForeground(grid, is_background);
  const PointStatistics statistics =
      Collect(grid, points, is_background, foreground, on_support, seeds, options);
  std::vector<std::vector<PottsEnergy::Choice>> choices(seeds.size() + 1);
  InterruptionPoint();
  for (int v = 0; v < static_cast<int>(grid.voxels.size()); ++v) {
    choices[0].push_back({v, statistics.background_cost[v]});
  }
  std::size_t num_choices = 0;
  const auto add_choices = [&](const std::vector<int>& members, const std::vector<int>& near) {
    const Positions means = Chosen(foreground.means, near);
    for (const int i : members) {
      InterruptionPoint();
      choices[i + 1] =
          ChoicesOfSeed(foreground, statistics.variance, near, means, seeds[i], options);
      num_choices += choices[i + 1].size();
      RequireFewChoices(num_choices);
    }
  };
  ForEachNeighborhood(PositionsOf(seeds), foreground.means, ChoiceReach(options), add_choices);
  return choices;
}

}  // namespace fovea
