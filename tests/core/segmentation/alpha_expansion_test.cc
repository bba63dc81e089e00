#include "core/segmentation/alpha_expansion.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "tests/core/segmentation/energy_of.h"

namespace fovea {
namespace {

using Choice = PottsEnergy::Choice;

// The lowest energy over all labellings, by trying each.
double Optimum(const PottsEnergy& energy) {
  const int num_labels = static_cast<int>(energy.choices.size());
  std::vector<int> labels(energy.num_nodes, 0);
  double best = std::numeric_limits<double>::infinity();
  while (true) {
    best = std::min(best, EnergyOf(energy, labels));
    int node = 0;
    while (node < energy.num_nodes && ++labels[node] == num_labels) labels[node++] = 0;
    if (node == energy.num_nodes) return best;
  }
}

PottsEnergy RandomEnergy(std::mt19937& random, int num_nodes, int num_labels) {
  PottsEnergy energy;
  energy.num_nodes = num_nodes;
  energy.choices = Lists<Choice>(num_labels);
  for (int label = 0; label < num_labels; ++label) {
    energy.choices.Begin(label);
    for (int node = 0; node < num_nodes; ++node) {
      if (label == 0 || random() % 4 != 0) {
        energy.choices.Add({node, static_cast<float>(random() % 1000) / 100});
      }
    }
  }
  for (int a = 0; a < num_nodes; ++a) {
    for (int b = a + 1; b < num_nodes; ++b) {
      if (random() % 3 == 0)
        energy.edges.push_back({a, b, static_cast<float>(random() % 500) / 100});
    }
  }
  return energy;
}

// With two labels one expansion of the second is an exact minimum cut from anywhere.
TEST(MinimizeByAlphaExpansion, IsOptimalWithTwoLabels) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    const PottsEnergy energy = RandomEnergy(random, 8, 2);
    const double reached = EnergyOf(energy, MinimizeByAlphaExpansion(energy, 10));
    EXPECT_NEAR(reached, Optimum(energy), 1e-3) << "seed " << seed;
  }
}

TEST(MinimizeByAlphaExpansion, StaysWithinTwiceTheOptimumWithFourLabels) {
  int exact = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    std::mt19937 random(seed);
    const PottsEnergy energy = RandomEnergy(random, 6, 4);
    const double reached = EnergyOf(energy, MinimizeByAlphaExpansion(energy, 20));
    const double optimum = Optimum(energy);
    EXPECT_LE(reached, 2 * optimum + 1e-3) << "seed " << seed;
    if (reached <= optimum + 1e-3) ++exact;
  }
  EXPECT_GE(exact, 90);  // in practice it is nearly always the optimum
}

TEST(MinimizeByAlphaExpansion, NeverGivesALabelThatIsNoChoice) {
  // Label 1 would be free for node 0 only; the strong edge drags node 0 to the background.
  PottsEnergy energy{.num_nodes = 2,
                     .choices = {{Choice{0, 1}, Choice{1, 1}}, {Choice{0, 0}}},
                     .edges = {{0, 1, 10}}};
  EXPECT_EQ(MinimizeByAlphaExpansion(energy, 5), (std::vector<int>{0, 0}));
  energy.edges[0].weight = 0.5F;
  EXPECT_EQ(MinimizeByAlphaExpansion(energy, 5), (std::vector<int>{1, 0}));
}

TEST(MinimizeByAlphaExpansion, HandlesSingleNodesNoEdgesAndNothing) {
  EXPECT_TRUE(MinimizeByAlphaExpansion({}, 5).empty());
  const PottsEnergy lone{.num_nodes = 1, .choices = {{Choice{0, 2}}, {Choice{0, 1}}}, .edges = {}};
  EXPECT_EQ(MinimizeByAlphaExpansion(lone, 5), (std::vector<int>{1}));
  const PottsEnergy tie{.num_nodes = 1, .choices = {{Choice{0, 1}}, {Choice{0, 1}}}, .edges = {}};
  EXPECT_EQ(MinimizeByAlphaExpansion(tie, 5), (std::vector<int>{0}));
}

TEST(EnergyOf, CountsCostsAndCutEdges) {
  const PottsEnergy energy{.num_nodes = 3,
                           .choices = {{Choice{0, 1}, Choice{1, 2}, Choice{2, 3}}, {Choice{1, 5}}},
                           .edges = {{0, 1, 7}, {1, 2, 11}}};
  EXPECT_DOUBLE_EQ(EnergyOf(energy, {0, 0, 0}), 6);
  EXPECT_DOUBLE_EQ(EnergyOf(energy, {0, 1, 0}), 1 + 5 + 3 + 7 + 11);
  EXPECT_EQ(EnergyOf(energy, {1, 0, 0}), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace fovea
