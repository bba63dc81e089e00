#include "core/segmentation/data_term.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/segmentation/foreground.h"
#include "core/segmentation/neighborhoods.h"
#include "core/types/interruption.h"
#include "core/types/too_complex.h"

namespace fovea {
namespace {

constexpr std::size_t kMaxChoices = std::size_t{1} << 25U;

void RequireFewChoices(std::size_t num_choices) {
  if (num_choices <= kMaxChoices) return;
  throw TooComplex(
      "too many voxels within reach of too many seeds; raise mrf.gamma_per_m2 or "
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

// Eq. 2 and 5 in closed form: the mean of γ‖x − x₀‖² over what a site consists of is
// γ(‖mean − x₀‖² + variance).
class ChoicesOfSeeds {
 public:
  ChoicesOfSeeds(const Sites& sites, const DataTermOptions& options)
      : sites_(sites),
        max_cost_(MaxCost(options)),
        max_squared_distance_(static_cast<float>(options.reach_m * options.reach_m)),
        gamma_per_m2_(options.gamma_per_m2),
        nearest_(sites.means.size(), std::numeric_limits<float>::infinity()) {}

  // Adds those of a seed. `near`: sites, ascending; `means`: theirs.
  void Add(const Seed& seed, const std::vector<int>& near, Positions& means,
           Lists<PottsEnergy::Choice>& choices) {
    const std::vector<float>& squared_distances = means.SquaredDistances(seed.position);
    for (std::size_t i = 0; i < near.size(); ++i) {
      const float squared_distance = squared_distances[i];
      if (squared_distance > max_squared_distance_) continue;
      const int site = near[i];
      const float squared = squared_distance + sites_.variances_m2[site];
      nearest_[site] = std::min(nearest_[site], squared);
      const auto cost = static_cast<float>(gamma_per_m2_ * squared);
      if (cost < max_cost_) choices.Add({site, cost * sites_.weights[site]});
    }
  }
  // Of each site the mean squared distance to the nearest seed in reach so far.
  const std::vector<float>& Nearest() const { return nearest_; }

 private:
  const Sites& sites_;
  const float max_cost_, max_squared_distance_;
  const double gamma_per_m2_;
  std::vector<float> nearest_;
};

}  // namespace

float BackgroundCost(float squared_distance, const DataTermOptions& options) {
  const double p_object = std::exp(-options.gamma_per_m2 * squared_distance);
  return static_cast<float>(
      -std::log(options.alpha * std::max(1 - p_object, options.min_probability)));
}

Lists<PottsEnergy::Choice> DataTerm(const Sites& sites, const std::vector<Seed>& seeds,
                                    const DataTermOptions& options) {
  constexpr std::size_t kUsualChoices = 8;  // of a site, or more
  Lists<PottsEnergy::Choice> choices(seeds.size() + 1);
  choices.Reserve(kUsualChoices * sites.means.size());
  ChoicesOfSeeds of_seeds(sites, options);
  Positions means;
  std::size_t num_choices = 0;
  const auto add_choices = [&](const std::vector<int>& members, const std::vector<int>& near) {
    means.Choose(sites.means, near);
    for (const int i : members) {
      InterruptionPoint();
      choices.Begin(i + 1);
      of_seeds.Add(seeds[i], near, means, choices);
      num_choices += choices[i + 1].size();
      RequireFewChoices(num_choices);
    }
  };
  ForEachNeighborhood(PositionsOf(seeds), sites.means, ChoiceReach(options), add_choices);
  InterruptionPoint();
  choices.Begin(0);
  for (int site = 0; site < static_cast<int>(sites.means.size()); ++site) {
    const float cost = BackgroundCost(of_seeds.Nearest()[site], options);
    choices.Add({site, cost * sites.weights[site]});
  }
  return choices;
}

}  // namespace fovea
