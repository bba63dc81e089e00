#include "core/segmentation/part_merge.h"

#include <cmath>
#include <limits>

#include "core/segmentation/labels.h"

namespace fovea {

std::vector<int> MergeParts(const VoxelGrid& grid, const std::vector<int>& labels,
                            const std::vector<MeanColor>& colors,
                            const CameraIntrinsics& intrinsics, const Eigen::Vector3f& up,
                            const PartMergeOptions& options) {
  if (options.min_probability >= 1) return labels;
  const double min_log_odds = std::log(options.min_probability / (1 - options.min_probability));
  SegmentGraph graph(grid, labels, colors, intrinsics, up);
  while (true) {
    double best = min_log_odds;
    SegmentPair pair{0, 0};
    for (const auto& [candidate, kinship] : graph.Pairs()) {
      const double log_odds = LogOdds(kinship);
      if (log_odds <= best) continue;
      best = log_odds;
      pair = candidate;
    }
    if (pair.second == 0) break;
    graph.Join(pair);
  }
  return Renumbered(labels, graph.Objects());
}

}  // namespace fovea
