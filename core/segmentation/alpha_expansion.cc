#include "core/segmentation/alpha_expansion.h"

#include <limits>
#include <utility>

#include "core/segmentation/adjacency.h"
#include "core/segmentation/binary_energy.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

struct Link {
  int node = 0;
  float weight = 0;
};

// So that an expansion only looks at its own part of the graph.
using Links = Adjacency<Link>;

Links LinksOf(const PottsEnergy& energy) {
  return Links(energy.num_nodes, energy.edges, [](const PottsEnergy::Edge& edge, int node) {
    return Link{node, edge.weight};
  });
}

struct Labelling {
  std::vector<int> labels;
  std::vector<float> costs;  // of each node's own label
};

Labelling CheapestLabels(const PottsEnergy& energy) {
  Labelling start{std::vector<int>(energy.num_nodes, 0),
                  std::vector<float>(energy.num_nodes, std::numeric_limits<float>::infinity())};
  for (int label = 0; label < static_cast<int>(energy.choices.size()); ++label) {
    InterruptionPoint();
    for (const PottsEnergy::Choice& choice : energy.choices[label]) {
      if (choice.cost >= start.costs[choice.node]) continue;
      start.labels[choice.node] = label;
      start.costs[choice.node] = choice.cost;
    }
  }
  return start;
}

// One move at a time: every node that a label offers itself to either keeps its label or takes that
// one.
class Expansion {
 public:
  Expansion(const PottsEnergy& potts, const Links& links, const Labelling& current)
      : potts_(potts), links_(links), current_(current), variable_of_(potts.num_nodes, -1) {
    moves_.reserve(potts.num_nodes);
    energy_.costs.reserve(potts.num_nodes);
    energy_.pairs.reserve(potts.edges.size());
  }

  // The moves that lower the energy. Until the next call.
  const std::vector<PottsEnergy::Choice>& Solve(int alpha) {
    moves_.clear();
    energy_.costs.clear();
    energy_.pairs.clear();
    for (const PottsEnergy::Choice& choice : potts_.choices[alpha]) {
      if (current_.labels[choice.node] == alpha) continue;
      variable_of_[choice.node] = static_cast<int>(moves_.size());
      moves_.push_back(choice);
    }
    for (std::size_t i = 0; i < moves_.size(); ++i) AddMove(static_cast<int>(i), alpha);
    for (const PottsEnergy::Choice& move : moves_) variable_of_[move.node] = -1;
    KeepTaken(minimizer_.Minimize(energy_));
    return moves_;
  }

 private:
  void KeepTaken(const std::vector<char>& is_taken) {
    std::size_t num_taken = 0;
    for (std::size_t i = 0; i < moves_.size(); ++i) {
      if (is_taken[i] != 0) moves_[num_taken++] = moves_[i];
    }
    moves_.resize(num_taken);
  }

  void AddMove(int a, int alpha) {
    const int node = moves_[a].node;
    float keep_cost = current_.costs[node];
    float take_cost = moves_[a].cost;
    for (const Link& link : links_.Of(node)) {
      const int b = variable_of_[link.node];
      const bool differ = current_.labels[node] != current_.labels[link.node];
      if (b < 0) {  // the neighbour stays as it is
        if (differ) keep_cost += link.weight;
        if (current_.labels[link.node] != alpha) take_cost += link.weight;
      } else if (a < b && !differ) {
        energy_.pairs.push_back({a, b, link.weight, link.weight});
      } else if (a < b) {
        // Costs the weight unless both take.
        keep_cost += link.weight;
        energy_.pairs.push_back({a, b, link.weight, 0});
      }
    }
    energy_.costs.push_back(take_cost - keep_cost);
  }

  const PottsEnergy& potts_;
  const Links& links_;
  const Labelling& current_;
  std::vector<int> variable_of_;  // of moves_, of each node; -1 between calls
  std::vector<PottsEnergy::Choice> moves_;
  BinaryEnergy energy_;
  BinaryMinimizer minimizer_;
};

// Expands one label after the other.
class Sweeps {
 public:
  Sweeps(const PottsEnergy& energy, Labelling start)
      : energy_(energy),
        links_(LinksOf(energy)),
        current_(std::move(start)),
        expansion_(energy, links_, current_) {}

  // Whether one over all labels changed anything.
  bool Run() {
    bool changed = false;
    for (int alpha = 0; alpha < static_cast<int>(energy_.choices.size()); ++alpha) {
      changed |= Expand(alpha);
    }
    return changed;
  }

  const std::vector<int>& Labels() const { return current_.labels; }

 private:
  bool Expand(int alpha) {
    InterruptionPoint();
    const std::vector<PottsEnergy::Choice>& moves = expansion_.Solve(alpha);
    for (const PottsEnergy::Choice& move : moves) {
      current_.labels[move.node] = alpha;
      current_.costs[move.node] = move.cost;
    }
    return !moves.empty();
  }

  const PottsEnergy& energy_;
  Links links_;
  Labelling current_;
  Expansion expansion_;
};

}  // namespace

std::vector<int> MinimizeByAlphaExpansion(const PottsEnergy& energy, int max_sweeps) {
  Sweeps sweeps(energy, CheapestLabels(energy));
  for (int n = 0; n < max_sweeps && sweeps.Run(); ++n) {
  }
  return sweeps.Labels();
}

}  // namespace fovea
