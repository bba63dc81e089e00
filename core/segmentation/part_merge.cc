#include "core/segmentation/part_merge.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/segmentation/labels.h"
#include "core/types/interruption.h"

namespace fovea {

std::vector<int> MergeParts(const VoxelGrid& grid, const std::vector<int>& labels,
                            const std::vector<MeanColor>& colors,
                            const CameraIntrinsics& intrinsics, const Eigen::Vector3f& up,
                            const PartMergeOptions& options) {
  if (options.min_probability >= 1) return labels;
  const double min_log_odds = std::log(options.min_probability / (1 - options.min_probability));
  SegmentGraph graph(grid, labels, colors, intrinsics, up);
  // Less the odds, pair: the most likely one first. Those whose odds have changed are left in.
  std::set<std::pair<double, SegmentPair>> candidates;
  const auto consider = [&](const SegmentPair& pair) {
    const double log_odds = LogOdds(graph.Pairs().at(pair));
    if (log_odds > min_log_odds) candidates.emplace(-log_odds, pair);
  };
  for (const auto& [pair, kinship] : graph.Pairs()) consider(pair);
  while (!candidates.empty()) {
    InterruptionPoint();
    const auto [negative_log_odds, pair] = *candidates.begin();
    candidates.erase(candidates.begin());
    const auto found = graph.Pairs().find(pair);
    if (found == graph.Pairs().end() || -LogOdds(found->second) != negative_log_odds) continue;
    graph.Join(pair);
    for (const int other : graph.NeighborsOf(pair.first)) {
      consider(std::minmax(pair.first, other));
    }
  }
  return Renumbered(labels, graph.Objects());
}

}  // namespace fovea
