#include "core/segmentation/clusters.h"

#include <gmock/gmock.h>

#include "tests/core/segmentation/energy_of.h"

namespace fovea {
namespace {

using ::testing::ElementsAre;

// Six nodes in a row, strongly tied except between 2 and 3; node 5 is left out.
const std::vector<PottsEnergy::Edge> kRow{{0, 1, 8}, {1, 2, 8}, {2, 3, 1}, {3, 4, 8}, {4, 5, 8}};
const std::vector<char> kIsLeftOut{0, 0, 0, 0, 0, 1};

TEST(FindClusters, JoinsAlongStrongEdgesUpToTheSize) {
  const Clusters pairs = FindClusters(kRow, kIsLeftOut, 2, 4);
  EXPECT_THAT(pairs.of_node, ElementsAre(0, 0, 1, 2, 2, -1));
  EXPECT_THAT(pairs.sizes, ElementsAre(2, 1, 2));
  const Clusters fours = FindClusters(kRow, kIsLeftOut, 4, 4);
  EXPECT_THAT(fours.of_node, ElementsAre(0, 0, 0, 1, 1, -1));
  EXPECT_THAT(fours.sizes, ElementsAre(3, 2));
}

TEST(FindClusters, OfSizeOneJoinsNothing) {
  EXPECT_THAT(FindClusters(kRow, kIsLeftOut, 1, 0).of_node, ElementsAre(0, 1, 2, 3, 4, -1));
}

TEST(EdgesBetween, SumsWhatParallelEdgesWeigh) {
  std::vector<PottsEnergy::Edge> edges = kRow;
  edges.push_back({4, 0, 2});
  const Clusters clusters = FindClusters(edges, kIsLeftOut, 4, 4);
  const auto between = EdgesBetween(clusters, edges);
  ASSERT_EQ(between.size(), 1U);
  EXPECT_EQ(between[0].a, 0);
  EXPECT_EQ(between[0].b, 1);
  EXPECT_EQ(between[0].weight, 1 + 2);
  EXPECT_THAT(WeightsOutwards(clusters, edges), ElementsAre(0, 8));
}

// As if what is left out were a node that can only be background.
TEST(Clusters, KeepTheDifferencesOfEnergy) {
  PottsEnergy whole{.num_nodes = 6, .choices = {{}, {}}, .edges = kRow};
  PottsEnergy joined{.num_nodes = 2, .choices = {{}, {}}, .edges = {}};
  const Clusters clusters = FindClusters(kRow, kIsLeftOut, 4, 4);
  joined.edges = EdgesBetween(clusters, kRow);
  const std::vector<float> outwards = WeightsOutwards(clusters, kRow);
  whole.choices.Begin(0);
  for (int node = 0; node < 6; ++node) whole.choices.Add({node, 10});
  whole.choices.Begin(1);
  for (int node = 0; node < 5; ++node) whole.choices.Add({node, 1.0F + node});
  joined.choices = {{{0, 30 - outwards[0]}, {1, 20 - outwards[1]}}, {{0, 1 + 2 + 3}, {1, 4 + 5}}};
  const auto gain = [&](const std::vector<int>& labels) {
    EXPECT_THAT(LabelsOfNodes(clusters, labels),
                ElementsAre(labels[0], labels[0], labels[0], labels[1], labels[1], 0));
    EXPECT_EQ(
        EnergyOf(whole, LabelsOfNodes(clusters, labels)) - EnergyOf(whole, {0, 0, 0, 0, 0, 0}),
        EnergyOf(joined, labels) - EnergyOf(joined, {0, 0}));
  };
  gain({1, 0});
  gain({0, 1});
  gain({1, 1});
}

}  // namespace
}  // namespace fovea
