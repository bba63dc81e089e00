// The neighbours of each node of an undirected graph, side by side.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/types/interruption.h"

namespace fovea {

// `Link` is what is known of a neighbour: at least which node it is.
template <typename Link>
class Adjacency {
 public:
  // Each of `edges` has two nodes, `a` and `b`; link(edge, node) makes what leads along it to that
  // one of them. The links of a node are in the order of the edges.
  template <typename Edge, typename MakeLink>
  Adjacency(std::size_t num_nodes, const std::vector<Edge>& edges, MakeLink link)
      : first_(num_nodes + 1, 0) {
    LongLoop loop;
    for (const Edge& edge : edges) {
      loop.Turn();
      ++first_[edge.a + 1];
      ++first_[edge.b + 1];
    }
    for (std::size_t node = 1; node < first_.size(); ++node) first_[node] += first_[node - 1];
    links_.resize(first_.back());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (const Edge& edge : edges) {
      loop.Turn();
      links_[next[edge.a]++] = link(edge, edge.b);
      links_[next[edge.b]++] = link(edge, edge.a);
    }
  }

  std::span<const Link> Of(int node) const {
    return {links_.data() + first_[node],
            static_cast<std::size_t>(first_[node + 1] - first_[node])};
  }

 private:
  std::vector<int> first_;  // of each node in links_; one more at the end
  std::vector<Link> links_;
};

}  // namespace fovea
