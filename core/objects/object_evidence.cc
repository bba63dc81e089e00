#include "core/objects/object_evidence.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "core/segmentation/labels.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr float kLevelCosine = 0.9F;

Placement PlacementOf(const Voxel& voxel, const Eigen::Vector3f& up,
                      const std::vector<Support>& supports, const SupportOptions& options) {
  return {.num_flat = IsOnSupport(supports, voxel.mean, options) ? 1 : 0,
          .num_level = voxel.normal.dot(up) > kLevelCosine ? 1 : 0};
}

// Of the segments in `labels`, an image of them.
void CountPixels(const cv::Mat& labels, const cv::Mat& standing,
                 std::vector<ObjectEvidence>& evidence) {
  for (int row = 0; row < labels.rows; ++row) {
    InterruptionPoint();
    const auto* label = labels.ptr<std::uint16_t>(row);
    const auto* stands = standing.ptr<std::uint8_t>(row);
    for (int first = 0, end = 1; first < labels.cols; first = end++) {
      while (end < labels.cols && label[end] == label[first]) ++end;
      if (label[first] == 0) continue;
      evidence[label[first] - 1].bounds_px |= cv::Rect(first, row, end - first, 1);
      evidence[label[first] - 1].num_pixels += end - first;
      evidence[label[first] - 1].num_missing +=
          static_cast<double>(end - first - std::count(stands + first, stands + end, 0));
    }
  }
}

void SetJoins(const MergeTree& tree, std::size_t n, ObjectEvidence& evidence) {
  const MergeNode& node = tree.nodes[n];
  evidence.outer_log_odds = node.parent >= 0 ? tree.nodes[node.parent].log_odds : tree.min_log_odds;
  if (node.parent >= 0) evidence.outer_terms = TermsOf(tree.nodes[node.parent].kinship);
}

// Which of the unions holds two segments first. The segments of each union so far are a tree, the
// smaller one below the larger: no way up is longer than the logarithm of their number.
class FirstUnions {
 public:
  explicit FirstUnions(const MergeTree& tree) : above_(tree.num_segments) {
    std::vector<int> root_of_node(tree.nodes.size());
    std::iota(root_of_node.begin(), root_of_node.begin() + above_.size(), 0);
    std::vector<int> sizes(tree.num_segments, 1);
    for (std::size_t n = tree.num_segments; n < tree.nodes.size(); ++n) {
      int larger = root_of_node[tree.nodes[n].left], smaller = root_of_node[tree.nodes[n].right];
      if (sizes[larger] < sizes[smaller]) std::swap(larger, smaller);
      sizes[larger] += sizes[smaller];
      above_[smaller] = {larger, static_cast<int>(n)};
      root_of_node[n] = larger;
    }
  }

  // Of two other segments, which are nodes of the tree too; none unless they are joined.
  std::optional<int> Of(int a, int b) const {
    int by = 0;
    while (a != b) {
      int& lower = above_[a].by < above_[b].by ? a : b;  // it was joined before
      by = above_[lower].by;
      if (by == kNever) return std::nullopt;
      lower = above_[lower].segment;
    }
    return by;
  }

 private:
  static constexpr int kNever = std::numeric_limits<int>::max();

  struct Above {
    int segment = 0;
    int by = kNever;  // the union that put it there
  };
  std::vector<Above> above_;
};

// But for the borders between the two, which are none any more.
void AddUp(const ObjectEvidence& other, ObjectEvidence& sum) {
  sum.part.Add(other.part);
  sum.placement.Add(other.placement);
  sum.borders.Add(other.borders);
  sum.num_pixels += other.num_pixels;
  sum.num_missing += other.num_missing;
  sum.bounds_px |= other.bounds_px;
  sum.num_segments += other.num_segments;
}

// Of each union the borders between what it joins.
std::vector<BorderCounts> InnerBorders(const std::vector<Facing>& facings, const MergeTree& tree) {
  const FirstUnions first(tree);
  std::vector<BorderCounts> inner(tree.nodes.size() - tree.num_segments);
  LongLoop loop;
  for (const Facing& facing : facings) {
    loop.Turn();
    const std::optional<int> node = first.Of(facing.own - 1, facing.other - 1);
    if (node) inner[*node - tree.num_segments].Count(facing.side, facing.beyond);
  }
  return inner;
}

}  // namespace

void Placement::Add(const Placement& other) {
  num_flat += other.num_flat;
  num_level += other.num_level;
}

SegmentEvidence LookAtSegments(const LabelledScene& scene, const std::vector<int>& segments,
                               const SupportOptions& support_options) {
  SegmentEvidence result;
  const cv::Mat image = LabelImage(scene.grid, segments);
  const std::vector<Part> parts =
      CollectParts(scene.grid, segments, scene.colors, scene.intrinsics, scene.up);
  Surroundings surroundings = FindSurroundings(scene, image);
  surroundings.counts.resize(parts.size());
  result.facings = std::move(surroundings.facings);
  std::vector<ObjectEvidence>& evidence = result.of_segments;
  evidence.resize(parts.size() - 1);
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    evidence[i].part = parts[i + 1];
    evidence[i].borders = surroundings.counts[i + 1];
  }
  CountPixels(image, scene.standing, evidence);
  LongLoop loop;
  for (std::size_t v = 0; v < segments.size(); ++v) {
    loop.Turn();
    if (segments[v] == 0) continue;
    evidence[segments[v] - 1].placement.Add(
        PlacementOf(scene.grid.voxels[v], scene.up, scene.supports, support_options));
  }
  return result;
}

std::vector<ObjectEvidence> CollectEvidence(SegmentEvidence segments, const MergeTree& tree) {
  const std::vector<BorderCounts> inner = InnerBorders(segments.facings, tree);
  std::vector<ObjectEvidence> evidence = std::move(segments.of_segments);
  evidence.resize(tree.nodes.size());
  for (std::size_t n = tree.num_segments; n < tree.nodes.size(); ++n) {
    InterruptionPoint();
    evidence[n] = evidence[tree.nodes[n].left];
    AddUp(evidence[tree.nodes[n].right], evidence[n]);
    evidence[n].borders.Add(inner[n - tree.num_segments], -1);
  }
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) SetJoins(tree, n, evidence[n]);
  return evidence;
}

}  // namespace fovea
