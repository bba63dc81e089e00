#include "core/segmentation/merge_tree.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

#include "core/segmentation/labels.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr double kSeparateLogOdds = 0;

class Builder {
 public:
  Builder(SegmentGraph graph, const std::vector<int>& labels)
      : graph_(std::move(graph)), labels_(labels), node_of_(CountLabels(labels) + 1, -1) {
    tree_.num_segments = node_of_.size() - 1;
    tree_.nodes.resize(tree_.num_segments);
    for (std::size_t label = 1; label < node_of_.size(); ++label) {
      node_of_[label] = static_cast<int>(label) - 1;
    }
    for (const auto& [pair, kinship] : graph_.Pairs()) Consider(pair);
  }

  void JoinDownTo(double min_log_odds) {
    while (!candidates_.empty() && -candidates_.top().first > min_log_odds) {
      InterruptionPoint();
      const auto [negative_log_odds, pair] = candidates_.top();
      candidates_.pop();
      const auto found = graph_.Pairs().find(pair);
      // Those whose odds have changed are left in.
      if (found == graph_.Pairs().end() || -LogOdds(found->second) != negative_log_odds) continue;
      Join(pair, -negative_log_odds);
    }
  }

  void JoinSeparate(const FindSeparate& find_separate) {
    const std::vector<int> before = Renumbered(labels_, graph_.Objects());
    const std::vector<int> after = find_separate(before);
    std::vector<int> first_of(CountLabels(after) + 1, 0);  // of each new object, its first segment
    for (std::size_t v = 0; v < labels_.size(); ++v) {
      if (labels_[v] == 0) continue;
      const int segment = graph_.Objects().Find(labels_[v]);
      int& first = first_of[after[v]];
      if (first == 0) first = segment;
      const int other = graph_.Objects().Find(first);
      if (other != segment) Join(std::minmax(other, segment), kSeparateLogOdds);
    }
  }

  void EndLikely() { tree_.num_likely = tree_.nodes.size(); }

  MergeTree Take() { return std::move(tree_); }

 private:
  void Consider(const SegmentPair& pair) {
    candidates_.emplace(-LogOdds(graph_.Pairs().at(pair)), pair);
  }

  void Join(const SegmentPair& pair, double log_odds) {
    const int node = static_cast<int>(tree_.nodes.size());
    const int left = node_of_[pair.first], right = node_of_[pair.second];
    const auto known = graph_.Pairs().find(pair);
    const Kinship kinship = known == graph_.Pairs().end() ? Kinship() : known->second;
    tree_.nodes.push_back({left, right, -1, log_odds, kinship});
    tree_.nodes[left].parent = tree_.nodes[right].parent = node;
    graph_.Join(pair);
    node_of_[pair.first] = node;
    for (const int other : graph_.NeighborsOf(pair.first)) {
      Consider(std::minmax(pair.first, other));
    }
  }

  SegmentGraph graph_;
  const std::vector<int>& labels_;
  std::vector<int> node_of_;                         // of each segment that stands for a joined one
  using Candidate = std::pair<double, SegmentPair>;  // −log odds first
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> candidates_;
  MergeTree tree_;
};

}  // namespace

std::vector<int> MergeTree::LikelyNodes() const {
  std::vector<int> likely;
  for (std::size_t n = 0; n < num_likely; ++n) {
    const int parent = nodes[n].parent;
    if (parent < 0 || static_cast<std::size_t>(parent) >= num_likely) {
      likely.push_back(static_cast<int>(n));
    }
  }
  return likely;
}

MergeTree BuildMergeTree(SegmentGraph graph, const std::vector<int>& labels, double min_log_odds,
                         const FindSeparate& find_separate) {
  Builder builder(std::move(graph), labels);
  builder.JoinDownTo(0);
  builder.JoinSeparate(find_separate);
  builder.EndLikely();
  builder.JoinDownTo(min_log_odds);
  MergeTree tree = builder.Take();
  tree.min_log_odds = min_log_odds;
  return tree;
}

}  // namespace fovea
