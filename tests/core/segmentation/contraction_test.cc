#include "core/segmentation/contraction.h"

#include <gtest/gtest.h>

#include "tests/core/segmentation/energy_of.h"

namespace fovea {
namespace {

// Six nodes in a row, strongly tied except between 2 and 3; node 5 can only be background.
PottsEnergy Row() {
  PottsEnergy energy;
  energy.num_nodes = 6;
  energy.choices.resize(3);
  for (int node = 0; node < 6; ++node) energy.choices[0].push_back({node, 10});
  for (int node = 0; node < 5; ++node) energy.choices[1].push_back({node, 1.0F + node});
  for (int node = 1; node < 5; ++node) energy.choices[2].push_back({node, 5.0F - node});
  energy.edges = {{0, 1, 8}, {1, 2, 8}, {2, 3, 1}, {3, 4, 8}, {4, 5, 8}};
  return energy;
}

TEST(Contract, JoinsAlongStrongEdgesUpToTheSize) {
  const Contraction pairs = Contract(Row(), 2, 4);
  EXPECT_EQ(pairs.cluster_of_node, (std::vector<int>{0, 0, 1, 2, 2, 3}));
  const Contraction fours = Contract(Row(), 4, 4);
  EXPECT_EQ(fours.cluster_of_node, (std::vector<int>{0, 0, 0, 1, 1, 2}));
}

TEST(Contract, SumsCostsAndWeights) {
  const PottsEnergy energy = Contract(Row(), 4, 4).energy;
  ASSERT_EQ(energy.num_nodes, 3);
  ASSERT_EQ(energy.choices[1].size(), 2U);
  EXPECT_EQ(energy.choices[1][0].cost, 1 + 2 + 3);
  EXPECT_EQ(energy.choices[1][1].cost, 4 + 5);
  ASSERT_EQ(energy.choices[2].size(), 1U);  // node 0 cannot take label 2, so its cluster cannot
  EXPECT_EQ(energy.choices[2][0].node, 1);
  ASSERT_EQ(energy.edges.size(), 2U);
  EXPECT_EQ(energy.edges[0].weight, 1);
  EXPECT_EQ(energy.edges[1].weight, 8);
}

TEST(Contract, KeepsTheEnergyOfLabellingsThatAgreeWithTheClusters) {
  const PottsEnergy energy = Row();
  const Contraction contraction = Contract(energy, 4, 4);
  const std::vector<int> labels{1, 2, 0};
  EXPECT_EQ(EnergyOf(energy, Expand(contraction, labels)), EnergyOf(contraction.energy, labels));
}

TEST(Contract, OfSizeOneChangesNothing) {
  const Contraction contraction = Contract(Row(), 1, 0);
  EXPECT_EQ(contraction.energy.num_nodes, 6);
  EXPECT_EQ(contraction.energy.edges.size(), 5U);
}

}  // namespace
}  // namespace fovea
