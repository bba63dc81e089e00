#include "core/segmentation/data_term.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/segmentation/foreground.h"
#include "core/segmentation/neighborhoods.h"
#include "core/segmentation/points_of_voxels.h"
#include "core/types/interruption.h"
#include "core/types/too_complex.h"

namespace fovea {
namespace {

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

// Of each voxel that is not background the mean squared distance of its points to their mean.
std::vector<float> Variances(const VoxelGrid& grid, const cv::Mat& points,
                             const std::vector<char>& is_background) {
  std::vector<float> variances(grid.voxels.size());
  ForEachPoint(grid, points, is_background, [&](int v, const Eigen::Vector3f& x, cv::Point) {
    const float share = 1.0F / static_cast<float>(grid.voxels[v].num_points);
    variances[v] += share * (x - grid.voxels[v].mean).squaredNorm();
  });
  return variances;
}

// Eq. 2 and 5 in closed form: the mean of γ‖x − x₀‖² over a voxel's points is
// γ(‖mean − x₀‖² + variance).
class ChoicesOfSeeds {
 public:
  ChoicesOfSeeds(const Foreground& foreground, const std::vector<float>& variance,
                 const DataTermOptions& options)
      : foreground_(foreground),
        variance_(variance),
        max_cost_(MaxCost(options)),
        max_squared_distance_(static_cast<float>(options.reach_m * options.reach_m)),
        gamma_per_m2_(options.gamma_per_m2),
        nearest_(variance.size(), std::numeric_limits<float>::infinity()) {}

  // Here `near` are of the foreground, ascending, and `means` theirs.
  std::vector<PottsEnergy::Choice> Of(const Seed& seed, const std::vector<int>& near,
                                      const Positions& means) {
    squared_distances_ = SquaredDistances(means, seed.position);
    choices_.clear();
    for (std::size_t i = 0; i < near.size(); ++i) {
      const float squared_distance = squared_distances_[static_cast<Eigen::Index>(i)];
      if (squared_distance > max_squared_distance_) continue;
      const int v = foreground_.voxels[near[i]];
      const float squared = squared_distance + variance_[v];
      nearest_[v] = std::min(nearest_[v], squared);
      const auto cost = static_cast<float>(gamma_per_m2_ * squared);
      if (cost < max_cost_) choices_.push_back({v, cost});
    }
    return choices_;
  }
  // Of each voxel the mean squared distance of its points to the nearest seed in reach so far.
  const std::vector<float>& Nearest() const { return nearest_; }

 private:
  const Foreground& foreground_;
  const std::vector<float>& variance_;
  const float max_cost_, max_squared_distance_;
  const double gamma_per_m2_;
  std::vector<float> nearest_;
  Eigen::ArrayXf squared_distances_;  // kept for their memory
  std::vector<PottsEnergy::Choice> choices_;
};

}  // namespace

float BackgroundCost(float squared_distance, const DataTermOptions& options) {
  const double p_object = std::exp(-options.gamma_per_m2 * squared_distance);
  return static_cast<float>(
      -std::log(options.alpha * std::max(1 - p_object, options.min_probability)));
}

std::vector<std::vector<PottsEnergy::Choice>> DataTerm(const VoxelGrid& grid, const cv::Mat& points,
                                                       const std::vector<char>& is_background,
                                                       const std::vector<Seed>& seeds,
                                                       const DataTermOptions& options) {
  const Foreground foreground = CollectForeground(grid, is_background);
  const std::vector<float> variances = Variances(grid, points, is_background);
  std::vector<std::vector<PottsEnergy::Choice>> choices(seeds.size() + 1);
  ChoicesOfSeeds of_seeds(foreground, variances, options);
  std::size_t num_choices = 0;
  const auto add_choices = [&](const std::vector<int>& members, const std::vector<int>& near) {
    const Positions means = Chosen(foreground.means, near);
    for (const int i : members) {
      InterruptionPoint();
      choices[i + 1] = of_seeds.Of(seeds[i], near, means);
      num_choices += choices[i + 1].size();
      RequireFewChoices(num_choices);
    }
  };
  ForEachNeighborhood(PositionsOf(seeds), foreground.means, ChoiceReach(options), add_choices);
  InterruptionPoint();
  choices[0].reserve(grid.voxels.size());
  for (int v = 0; v < static_cast<int>(grid.voxels.size()); ++v) {
    const float cost = is_background[v] != 0 ? 0 : BackgroundCost(of_seeds.Nearest()[v], options);
    choices[0].push_back({v, cost});
  }
  return choices;
}

}  // namespace fovea
