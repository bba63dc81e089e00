#include "core/segmentation/binary_energy.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>

namespace fovea {
namespace {

std::vector<char> Minimize(const BinaryEnergy& energy) {
  return BinaryMinimizer().Minimize(energy);
}

// `taken` has one bit a node.
float EnergyOf(const BinaryEnergy& energy, unsigned taken) {
  const auto is_taken = [&](int v) { return (taken >> static_cast<unsigned>(v) & 1U) != 0; };
  float sum = 0;
  for (int v = 0; v < static_cast<int>(energy.costs.size()); ++v) {
    if (is_taken(v)) sum += energy.costs[v];
  }
  for (const BinaryEnergy::Pair& pair : energy.pairs) {
    if (is_taken(pair.a) && !is_taken(pair.b)) sum += pair.cost_a;
    if (is_taken(pair.b) && !is_taken(pair.a)) sum += pair.cost_b;
  }
  return sum;
}

unsigned Bits(const std::vector<char>& taken) {
  unsigned bits = 0;
  for (std::size_t v = 0; v < taken.size(); ++v) bits |= (taken[v] != 0 ? 1U : 0U) << v;
  return bits;
}

// Whole numbers: sums are exact and many labellings cost the same.
BinaryEnergy RandomEnergy(int num_nodes, int num_pairs, std::mt19937& random) {
  const auto number = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  BinaryEnergy energy;
  for (int v = 0; v < num_nodes; ++v) energy.costs.push_back(static_cast<float>(number(-4, 4)));
  while (static_cast<int>(energy.pairs.size()) < num_pairs) {
    const int a = number(0, num_nodes - 1);
    const int b = number(0, num_nodes - 1);
    if (a == b) continue;
    energy.pairs.push_back(
        {a, b, static_cast<float>(number(0, 3)), static_cast<float>(number(0, 3))});
  }
  return energy;
}

TEST(BinaryEnergy, NothingHasNothingToTake) { EXPECT_TRUE(Minimize({}).empty()); }

TEST(BinaryEnergy, ANodeAloneIsTakenWhereThatIsCheaper) {
  EXPECT_EQ(Minimize({{-1, 0, 1}, {}}), (std::vector<char>{1, 0, 0}));
}

TEST(BinaryEnergy, NeighboursDecideTogether) {
  const std::vector<BinaryEnergy::Pair> chain{{0, 1, 2, 2}, {1, 2, 2, 2}};
  EXPECT_EQ(Minimize({{-3, 0, 1}, chain}), (std::vector<char>{1, 1, 1}));
  EXPECT_EQ(Minimize({{-3, 1, 3}, chain}), (std::vector<char>{1, 0, 0}));
  EXPECT_EQ(Minimize({{-1, 1, 3}, chain}), (std::vector<char>{0, 0, 0}));
}

TEST(BinaryEnergy, IsTheLeastOfAllWithTheFewestTaken) {
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round) {
    const int num_nodes = 2 + round % 8;
    const BinaryEnergy energy = RandomEnergy(num_nodes, 2 * num_nodes, random);
    const unsigned found = Bits(Minimize(energy));
    const float least = EnergyOf(energy, found);
    for (unsigned other = 0; other < 1U << static_cast<unsigned>(num_nodes); ++other) {
      const float cost = EnergyOf(energy, other);
      ASSERT_GE(cost, least);
      if (cost > least) continue;
      ASSERT_GE(std::popcount(other), std::popcount(found));
    }
  }
}

}  // namespace
}  // namespace fovea
