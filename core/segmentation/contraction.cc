#include "core/segmentation/contraction.h"

#include <algorithm>
#include <utility>

#include "core/segmentation/disjoint_sets.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

// Whether each node can take a label above 0.
std::vector<char> HaveChoice(const PottsEnergy& energy) {
  std::vector<char> have(energy.num_nodes, 0);
  for (std::size_t label = 1; label < energy.choices.size(); ++label) {
    InterruptionPoint();
    for (const PottsEnergy::Choice& choice : energy.choices[label]) have[choice.node] = 1;
  }
  return have;
}

// Cluster numbers in the order of their first nodes; their sizes.
struct Clusters {
  std::vector<int> of_node;
  std::vector<int> sizes;
};

Clusters FindClusters(const PottsEnergy& energy, int max_size, float min_weight) {
  const std::vector<char> have_choice = HaveChoice(energy);
  DisjointSets sets(energy.num_nodes);
  std::vector<int> sizes(energy.num_nodes, 1);  // of a set, at its first node
  for (int limit = 2; limit <= max_size; limit *= 2) {
    InterruptionPoint();
    for (const PottsEnergy::Edge& edge : energy.edges) {
      if (edge.weight < min_weight || !have_choice[edge.a] || !have_choice[edge.b]) continue;
      const int a = sets.Find(edge.a);
      const int b = sets.Find(edge.b);
      if (a == b || sizes[a] + sizes[b] > limit) continue;
      const int size = sizes[a] + sizes[b];
      sets.Join(a, b);
      sizes[sets.Find(a)] = size;
    }
  }
  Clusters clusters{std::vector<int>(energy.num_nodes), {}};
  for (int node = 0; node < energy.num_nodes; ++node) {
    const int first = sets.Find(node);
    if (first == node) {
      clusters.of_node[node] = static_cast<int>(clusters.sizes.size());
      clusters.sizes.push_back(sizes[node]);
    } else {
      clusters.of_node[node] = clusters.of_node[first];
    }
  }
  return clusters;
}

class ChoicesOfClusters {
 public:
  explicit ChoicesOfClusters(const Clusters& clusters)
      : clusters_(clusters), sums_(clusters.sizes.size()) {}

  // What a label costs the clusters all of whose nodes it offers itself to, clusters ascending: of
  // such a cluster the first node is met first, and those number the clusters.
  std::vector<PottsEnergy::Choice> Join(const std::vector<PottsEnergy::Choice>& choices) {
    met_.clear();
    for (const PottsEnergy::Choice& choice : choices) {
      const int cluster = clusters_.of_node[choice.node];
      if (sums_[cluster].num_nodes++ == 0) met_.push_back(cluster);
      sums_[cluster].cost += choice.cost;
    }
    std::vector<PottsEnergy::Choice> joined;
    joined.reserve(met_.size());
    for (const int cluster : met_) {
      const Sum sum = std::exchange(sums_[cluster], {});
      if (sum.num_nodes == clusters_.sizes[cluster]) joined.push_back({cluster, sum.cost});
    }
    return joined;
  }

 private:
  // Of the nodes of a cluster that a label offers itself to.
  struct Sum {
    float cost = 0;
    int num_nodes = 0;
  };

  const Clusters& clusters_;
  std::vector<Sum> sums_;  // empty between calls
  std::vector<int> met_;
};

std::vector<PottsEnergy::Edge> JoinEdges(const std::vector<PottsEnergy::Edge>& edges,
                                         const Clusters& clusters) {
  std::vector<PottsEnergy::Edge> joined;
  joined.reserve(edges.size());
  for (const PottsEnergy::Edge& edge : edges) {
    const auto [a, b] = std::minmax(clusters.of_node[edge.a], clusters.of_node[edge.b]);
    if (a != b) joined.push_back({a, b, edge.weight});
  }
  std::stable_sort(joined.begin(), joined.end(), [](const auto& x, const auto& y) {
    return std::pair(x.a, x.b) < std::pair(y.a, y.b);
  });
  std::size_t kept = 0;
  InterruptionPoint();
  for (const PottsEnergy::Edge& edge : joined) {
    if (kept > 0 && joined[kept - 1].a == edge.a && joined[kept - 1].b == edge.b) {
      joined[kept - 1].weight += edge.weight;
    } else {
      joined[kept++] = edge;
    }
  }
  joined.resize(kept);
  return joined;
}

}  // namespace

Contraction Contract(const PottsEnergy& energy, int max_size, float min_weight) {
  Clusters clusters = FindClusters(energy, max_size, min_weight);
  Contraction contraction;
  contraction.energy.num_nodes = static_cast<int>(clusters.sizes.size());
  contraction.energy.choices.reserve(energy.choices.size());
  ChoicesOfClusters joined(clusters);
  for (const std::vector<PottsEnergy::Choice>& choices : energy.choices) {
    InterruptionPoint();
    contraction.energy.choices.push_back(joined.Join(choices));
  }
  contraction.energy.edges = JoinEdges(energy.edges, clusters);
  contraction.cluster_of_node = std::move(clusters.of_node);
  return contraction;
}

std::vector<int> Expand(const Contraction& contraction, const std::vector<int>& cluster_labels) {
  std::vector<int> labels;
  labels.reserve(contraction.cluster_of_node.size());
  for (const int cluster : contraction.cluster_of_node) labels.push_back(cluster_labels[cluster]);
  return labels;
}

}  // namespace fovea
