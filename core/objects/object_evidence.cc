#include "core/objects/object_evidence.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/segmentation/labels.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr float kLevelCosine = 0.9F;

bool IsCovered(const std::vector<Support>& supports, const Eigen::Vector3f& point,
               const SupportOptions& options) {
  const float tolerance = SupportTolerance(point.z(), options);
  return std::any_of(supports.begin(), supports.end(), [&](const Support& support) {
    return -support.surface.HeightOf(point) > support.LargestShare() * tolerance &&
           support.footprint.Covers(point);
  });
}

Placement PlacementOf(const Voxel& voxel, const Eigen::Vector3f& up,
                      const std::vector<Support>& supports, const SupportOptions& options) {
  return {.num_flat = IsOnSupport(supports, voxel.mean, options) ? 1 : 0,
          .num_covered = IsCovered(supports, voxel.mean, options) ? 1 : 0,
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
  evidence.inner_log_odds = node.log_odds;
  evidence.outer_log_odds = node.parent >= 0 ? tree.nodes[node.parent].log_odds : tree.min_log_odds;
  if (node.parent >= 0) evidence.outer_terms = TermsOf(tree.nodes[node.parent].kinship);
  evidence.is_likely = n < tree.num_likely && evidence.outer_log_odds < 0;
}

// Sums the evidence of unions in the order in which they were made.
class Summation {
 public:
  Summation(std::vector<ObjectEvidence>& evidence, std::vector<Surroundings> surroundings)
      : evidence_(evidence),
        top_of_(surroundings.size(), -1),
        towards_(evidence.size()),
        members_(evidence.size()),
        next_(surroundings.size(), 0) {
    for (int label = 1; label < static_cast<int>(surroundings.size()); ++label) {
      top_of_[label] = label - 1;
      members_[label - 1] = {label, label, 1};
      towards_[label - 1] = std::move(surroundings[label].towards);
    }
  }

  void Sum(int node, int left, int right) {
    ObjectEvidence& sum = evidence_[node];
    sum = evidence_[left];
    const ObjectEvidence& other = evidence_[right];
    sum.part.Add(other.part);
    sum.placement.Add(other.placement);
    sum.borders.Add(other.borders);
    sum.num_pixels += other.num_pixels;
    sum.num_missing += other.num_missing;
    sum.bounds_px |= other.bounds_px;
    sum.num_segments += other.num_segments;
    RemoveInner(left, right, sum.borders);
    RemoveInner(right, left, sum.borders);
    Unite(node, left, right);
  }

 private:
  // Labels, each with the next one in next_; 0 after the last.
  struct Members {
    int first = 0, last = 0;
    std::size_t count = 0;
  };

  // The borders of one child that face the other are none any more. Looks through the shorter list:
  // in noise, what is left over touches thousands.
  void RemoveInner(int child, int other, BorderCounts& sum) {
    std::map<int, BorderCounts>& towards = towards_[child];
    const auto remove = [&](auto entry) {
      sum.Add(entry->second, -1);
      return towards.erase(entry);
    };
    if (members_[other].count < towards.size()) {
      for (int label = members_[other].first; label != 0; label = next_[label]) {
        if (const auto entry = towards.find(label); entry != towards.end()) remove(entry);
      }
      return;
    }
    for (auto entry = towards.begin(); entry != towards.end();) {
      entry = top_of_[entry->first] == other ? remove(entry) : std::next(entry);
    }
  }

  // What is known of the smaller one is added to that of the larger one.
  void Unite(int node, int left, int right) {
    if (members_[left].count < members_[right].count) std::swap(left, right);
    towards_[node] = std::move(towards_[left]);
    for (const auto& [label, counts] : towards_[right]) towards_[node][label].Add(counts);
    const Members &larger = members_[left], &smaller = members_[right];
    next_[larger.last] = smaller.first;
    members_[node] = {larger.first, smaller.last, larger.count + smaller.count};
    for (int label = larger.first; label != 0; label = next_[label]) top_of_[label] = node;
    towards_[right].clear();
  }

  std::vector<ObjectEvidence>& evidence_;
  std::vector<int> top_of_;                           // of each label, the largest node so far
  std::vector<std::map<int, BorderCounts>> towards_;  // of each largest node
  std::vector<Members> members_;                      // of each largest node
  std::vector<int> next_;                             // of each label
};

}  // namespace

void Placement::Add(const Placement& other) {
  num_flat += other.num_flat;
  num_covered += other.num_covered;
  num_level += other.num_level;
}

SegmentEvidence LookAtSegments(const LabelledScene& scene, const std::vector<int>& segments,
                               const SupportOptions& support_options) {
  SegmentEvidence result;
  const cv::Mat image = LabelImage(scene.grid, segments);
  const std::vector<Part> parts =
      CollectParts(scene.grid, segments, scene.colors, scene.intrinsics, scene.up);
  result.surroundings = FindSurroundings(scene, image);
  result.surroundings.resize(parts.size());
  std::vector<ObjectEvidence>& evidence = result.of_segments;
  evidence.resize(parts.size() - 1);
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    evidence[i].part = parts[i + 1];
    evidence[i].borders = result.surroundings[i + 1].counts;
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
  std::vector<ObjectEvidence> evidence = std::move(segments.of_segments);
  evidence.resize(tree.nodes.size());
  Summation summation(evidence, std::move(segments.surroundings));
  for (std::size_t n = tree.num_segments; n < tree.nodes.size(); ++n) {
    InterruptionPoint();
    const MergeNode& node = tree.nodes[n];
    summation.Sum(static_cast<int>(n), node.left, node.right);
  }
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) SetJoins(tree, n, evidence[n]);
  return evidence;
}

}  // namespace fovea
