// Minimisation of an energy of yes-no decisions, by an exact minimum cut.
#pragma once

#include <memory>
#include <vector>

namespace fovea {

// E(x) = Σ_v cost_v · x_v + Σ_(a,b) (cost_a · [only a] + cost_b · [only b]), where x_v is 1 for the
// nodes that are taken. Such energies are those that a minimum cut minimises (Kolmogorov and Zabih
// 2004).
struct BinaryEnergy {
  struct Pair {
    int a = 0;
    int b = 0;
    float cost_a = 0;  // ≥ 0; where a is taken and b is not
    float cost_b = 0;  // ≥ 0; where b is taken and a is not
  };

  std::vector<float> costs;  // of taking each node; negative where that is cheaper than not to
  std::vector<Pair> pairs;
};

// Keeps its memory from one energy to the next.
class BinaryMinimizer {
 public:
  BinaryMinimizer();
  ~BinaryMinimizer();

  // One entry a node, 1 = taken: the least energy with the fewest nodes taken. Until the next call.
  const std::vector<char>& Minimize(const BinaryEnergy& energy);

 private:
  class GainFlow;
  std::unique_ptr<GainFlow> flow_;
};

}  // namespace fovea
