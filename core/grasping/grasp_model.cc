#include "core/grasping/grasp_model.h"

#include <algorithm>
#include <cmath>

#include "core/types/widest_registers.h"

namespace fovea {
namespace {

constexpr std::size_t kAtOnce = 16;

// Terms and log-odds of some grasps at once.
struct SomeGrasps {
  std::array<std::array<float, kAtOnce>, kNumGraspTerms> terms{};
  std::array<int, kAtOnce> sums{};  // thousandths
};

void AddTrees(const GraspFunction& function, SomeGrasps& grasps) {
  RunInWidestRegisters([&] {
    grasps.sums.fill(function.bias);
    for (const GraspTree& tree : function.trees) {
      std::array<std::uint32_t, kAtOnce> leaves{};
      for (std::size_t level = 0; level < GraspTree::kDepth; ++level) {
        const std::array<float, kAtOnce>& terms = grasps.terms[tree.terms[level]];
        const float threshold = tree.thresholds[level];
        const std::uint32_t bit = 1U << level;
        for (std::size_t i = 0; i < kAtOnce; ++i) leaves[i] |= terms[i] > threshold ? bit : 0;
      }
      for (std::size_t i = 0; i < kAtOnce; ++i) grasps.sums[i] += tree.values[leaves[i]];
    }
  });
}

double LogOddsOf(int thousandths) { return thousandths / 1000.0; }

}  // namespace

int GraspTree::Of(const GraspTerms& of_grasp) const {
  std::size_t leaf = 0;
  for (std::size_t level = 0; level < kDepth; ++level) {
    const bool is_above = of_grasp[terms[level]] > thresholds[level];
    leaf |= static_cast<std::size_t>(is_above) << level;
  }
  return values[leaf];
}

double GraspFunction::LogOdds(const GraspTerms& terms) const {
  int sum = bias;
  for (const GraspTree& tree : trees) sum += tree.Of(terms);
  return LogOddsOf(sum);
}

void GraspModel::SetProbabilities(std::vector<ScoredGrasp>& grasps) const {
  std::array<std::vector<ScoredGrasp*>, kNumGraspFamilies> by_family;
  for (ScoredGrasp& grasp : grasps) {
    by_family[static_cast<std::size_t>(grasp.family)].push_back(&grasp);
  }
  for (std::size_t family = 0; family < kNumGraspFamilies; ++family) {
    const std::vector<ScoredGrasp*>& own = by_family[family];
    for (std::size_t first = 0; first < own.size(); first += kAtOnce) {
      const std::size_t num = std::min(kAtOnce, own.size() - first);
      SomeGrasps some;
      for (std::size_t i = 0; i < num; ++i) {
        for (std::size_t t = 0; t < kNumGraspTerms; ++t)
          some.terms[t][i] = own[first + i]->terms[t];
      }
      AddTrees(families[family], some);
      for (std::size_t i = 0; i < num; ++i) {
        own[first + i]->grasp.probability =
            static_cast<float>(1 / (1 + std::exp(-LogOddsOf(some.sums[i]))));
      }
    }
  }
}

}  // namespace fovea
