#include "core/segmentation/clusters.h"

#include <algorithm>
#include <utility>

#include "core/segmentation/disjoint_sets.h"
#include "core/types/interruption.h"

namespace fovea {

Clusters FindClusters(const std::vector<PottsEnergy::Edge>& edges,
                      const std::vector<char>& is_left_out, int max_size, float min_weight) {
  const int num_nodes = static_cast<int>(is_left_out.size());
  DisjointSets sets(num_nodes);
  std::vector<int> sizes(num_nodes, 1);  // of a set, at its first node
  for (int limit = 2; limit <= max_size; limit *= 2) {
    InterruptionPoint();
    for (const PottsEnergy::Edge& edge : edges) {
      if (edge.weight < min_weight || is_left_out[edge.a] || is_left_out[edge.b]) continue;
      const int a = sets.Find(edge.a);
      const int b = sets.Find(edge.b);
      if (a == b || sizes[a] + sizes[b] > limit) continue;
      const int size = sizes[a] + sizes[b];
      sets.Join(a, b);
      sizes[sets.Find(a)] = size;
    }
  }
  Clusters clusters{std::vector<int>(num_nodes, -1), {}};
  clusters.sizes.reserve(num_nodes);
  for (int node = 0; node < num_nodes; ++node) {
    if (is_left_out[node]) continue;
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

std::vector<PottsEnergy::Edge> EdgesBetween(const Clusters& clusters,
                                            const std::vector<PottsEnergy::Edge>& edges) {
  std::vector<PottsEnergy::Edge> joined;
  joined.reserve(edges.size());
  for (const PottsEnergy::Edge& edge : edges) {
    const auto [a, b] = std::minmax(clusters.of_node[edge.a], clusters.of_node[edge.b]);
    if (a >= 0 && a != b) joined.push_back({a, b, edge.weight});
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

std::vector<float> WeightsOutwards(const Clusters& clusters,
                                   const std::vector<PottsEnergy::Edge>& edges) {
  std::vector<float> weights(clusters.sizes.size(), 0);
  InterruptionPoint();
  for (const PottsEnergy::Edge& edge : edges) {
    const auto [outside, cluster] = std::minmax(clusters.of_node[edge.a], clusters.of_node[edge.b]);
    if (outside < 0 && cluster >= 0) weights[cluster] += edge.weight;
  }
  return weights;
}

std::vector<int> LabelsOfNodes(const Clusters& clusters, const std::vector<int>& cluster_labels) {
  std::vector<int> labels;
  labels.reserve(clusters.of_node.size());
  for (const int cluster : clusters.of_node) {
    labels.push_back(cluster < 0 ? 0 : cluster_labels[cluster]);
  }
  return labels;
}

}  // namespace fovea
