// Push-relabel (Goldberg and Tarjan 1988), highest label first, with gap and global relabelling
// (Cherkassky and Goldberg 1997).
//
// What a node gains by being taken flows along the pairs, which let through their costs, to nodes
// that lose by being taken, which swallow as much as they lose. The nodes where gain is left over
// in the end, and all to which it could flow, are taken.
#include "core/segmentation/binary_energy.h"

#include <algorithm>
#include <cstddef>

#include "core/types/interruption.h"

namespace fovea {

class BinaryMinimizer::GainFlow {
 public:
  void Begin(const BinaryEnergy& energy) {
    nodes_.assign(energy.costs.size(), {});
    found_.reserve(nodes_.size());
    out_of_reach_ = static_cast<int>(nodes_.size()) + 2;
    first_active_.resize(out_of_reach_);
    num_at_height_.assign(out_of_reach_, 0);
    for (std::size_t v = 0; v < nodes_.size(); ++v) {
      nodes_[v].gain = std::max(0.0F, -energy.costs[v]);
      nodes_[v].loss = std::max(0.0F, energy.costs[v]);
    }
    AddArcs(energy.pairs);
  }

  void Run() {
    StartHeights();
    LongLoop loop;
    while (highest_ > 0) {
      loop.Turn();
      const int v = first_active_[highest_];
      if (v < 0) {
        --highest_;
        continue;
      }
      first_active_[highest_] = nodes_[v].next_active;
      if (nodes_[v].height == highest_) Discharge(v);  // else a gap put it out of reach
      if (num_relabels_ > static_cast<int>(nodes_.size())) RelabelAll();
    }
  }

  const std::vector<char>& WhereGainIsLeft() {
    std::vector<char>& left = left_;
    std::vector<int>& reached = found_;
    left.assign(nodes_.size(), 0);
    reached.clear();
    const auto reach = [&](int v) {
      if (left[v] != 0) return;
      left[v] = 1;
      reached.push_back(v);
    };
    for (int v = 0; v < static_cast<int>(nodes_.size()); ++v) {
      if (nodes_[v].gain > 0) reach(v);
    }
    while (!reached.empty()) {
      const Node& node = nodes_[reached.back()];
      reached.pop_back();
      for (int arc = node.first_arc; arc < node.end_arc; ++arc) {
        if (arcs_[arc].capacity > 0) reach(arcs_[arc].head);
      }
    }
    return left;
  }

 private:
  struct Node {
    int first_arc = 0;
    int end_arc = 0;
    int arc = 0;     // those before it lead nowhere
    int height = 0;  // at most the number of steps to where gain is swallowed, itself one
    int next_active = -1;
    float gain = 0;  // waits to flow on
    float loss = 0;  // what it can still swallow
  };
  struct Arc {
    int head;
    int reverse;
    float capacity;
  };

  void AddArcs(const std::vector<BinaryEnergy::Pair>& pairs) {
    for (const BinaryEnergy::Pair& pair : pairs) {
      ++nodes_[pair.a].end_arc;
      ++nodes_[pair.b].end_arc;
    }
    int end = 0;
    for (Node& node : nodes_) {
      node.first_arc = end;
      end += node.end_arc;
      node.end_arc = node.first_arc;
    }
    arcs_.resize(end);
    InterruptionPoint();
    for (const BinaryEnergy::Pair& pair : pairs) {
      const int from_a = nodes_[pair.a].end_arc++;
      const int from_b = nodes_[pair.b].end_arc++;
      arcs_[from_a] = {pair.b, from_b, pair.cost_a};
      arcs_[from_b] = {pair.a, from_a, pair.cost_b};
    }
  }

  void Activate(int v) {
    Node& node = nodes_[v];
    if (node.height == out_of_reach_) return;
    node.next_active = first_active_[node.height];
    first_active_[node.height] = v;
    highest_ = std::max(highest_, node.height);
  }

  // Heights that are not too large, as far as a look at each node by itself tells: exact ones cost
  // more than they save here.
  void StartHeights() {
    InterruptionPoint();
    for (Node& node : nodes_) {
      node.arc = node.first_arc;
      node.height = node.loss > 0 ? 1 : 2;
      ++num_at_height_[node.height];
    }
    ActivateAll();
  }

  void ActivateAll() {
    num_relabels_ = 0;
    highest_ = 0;
    std::fill(first_active_.begin(), first_active_.end(), -1);
    for (int v = 0; v < static_cast<int>(nodes_.size()); ++v) {
      if (nodes_[v].gain > 0) Activate(v);
    }
  }

  // Makes every height exact, by a breadth-first search.
  void RelabelAll() {
    InterruptionPoint();
    std::vector<int>& found = found_;
    found.clear();
    for (int v = 0; v < static_cast<int>(nodes_.size()); ++v) {
      nodes_[v].arc = nodes_[v].first_arc;
      nodes_[v].height = nodes_[v].loss > 0 ? 1 : out_of_reach_;
      if (nodes_[v].loss > 0) found.push_back(v);
    }
    std::fill(num_at_height_.begin(), num_at_height_.end(), 0);
    for (std::size_t next = 0; next < found.size(); ++next) {
      const Node& node = nodes_[found[next]];
      ++num_at_height_[node.height];
      for (int arc = node.first_arc; arc < node.end_arc; ++arc) {
        Node& from = nodes_[arcs_[arc].head];
        if (from.height < out_of_reach_ || arcs_[arcs_[arc].reverse].capacity <= 0) continue;
        from.height = node.height + 1;
        found.push_back(arcs_[arc].head);
      }
    }
    ActivateAll();
  }

  // Lets the gain of a node flow until none is left or none can be swallowed.
  void Discharge(int v) {
    Node& node = nodes_[v];
    while (node.height < out_of_reach_) {
      const float swallowed = std::min(node.gain, node.loss);
      node.gain -= swallowed;
      node.loss -= swallowed;
      for (; node.gain > 0 && node.arc < node.end_arc; ++node.arc) {
        Push(node, arcs_[node.arc]);
        if (node.gain <= 0) break;  // the arc may let more through
      }
      if (node.gain <= 0) return;
      Relabel(node);
    }
  }

  // Only downhill.
  void Push(Node& node, Arc& arc) {
    Node& to = nodes_[arc.head];
    if (arc.capacity <= 0 || node.height != to.height + 1) return;
    const bool is_active = to.gain > 0;
    const float amount = std::min(node.gain, arc.capacity);
    node.gain -= amount;
    to.gain += amount;
    arc.capacity -= amount;
    arcs_[arc.reverse].capacity += amount;
    if (!is_active) Activate(arc.head);
  }

  void Relabel(Node& node) {
    ++num_relabels_;
    const int before = node.height;
    node.height = out_of_reach_;
    for (int arc = node.first_arc; arc < node.end_arc; ++arc) {
      const int above = nodes_[arcs_[arc].head].height + 1;
      if (arcs_[arc].capacity <= 0 || above >= node.height) continue;
      node.height = above;
      node.arc = arc;
    }
    if (node.height < out_of_reach_) ++num_at_height_[node.height];
    if (--num_at_height_[before] == 0) CutOffAbove(before);
  }

  // Over a height at which there is no node nothing flows down.
  void CutOffAbove(int gap) {
    InterruptionPoint();
    for (Node& node : nodes_) {
      if (node.height <= gap || node.height == out_of_reach_) continue;
      --num_at_height_[node.height];
      node.height = out_of_reach_;
    }
  }

  std::vector<Node> nodes_;
  std::vector<Arc> arcs_;
  int out_of_reach_ = 0;            // more than any height
  std::vector<int> first_active_;   // of the nodes with gain of each height; -1 = none
  std::vector<int> num_at_height_;  // how many nodes
  int highest_ = 0;                 // height with active nodes
  int num_relabels_ = 0;            // since the last RelabelAll
  std::vector<int> found_;          // scratch
  std::vector<char> left_;
};

BinaryMinimizer::BinaryMinimizer() : flow_(std::make_unique<GainFlow>()) {}
BinaryMinimizer::~BinaryMinimizer() = default;

const std::vector<char>& BinaryMinimizer::Minimize(const BinaryEnergy& energy) {
  flow_->Begin(energy);
  flow_->Run();
  return flow_->WhereGainIsLeft();
}

}  // namespace fovea
