#include "tests/evaluation/object_fit/tree_samples.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>

#include "core/segmentation/labels.h"

namespace fovea::evaluation {
namespace {

constexpr double kRight = 0.5;    // IoU of what is right
constexpr double kAlmost = 0.06;  // less IoU than the best

// How much a node overlaps the true object that it overlaps most.
struct Overlap {
  double iou = 0;
  int object = -1;
  bool is_optional = false;  // it overlaps an optional object
};

// What a node has of each true object, in pixels, and where it is.
struct Pixels {
  double count = 0;
  std::map<int, double> of_object;
  cv::Rect bounds;

  void Add(const Pixels& other) {
    count += other.count;
    for (const auto& [object, number] : other.of_object) of_object[object] += number;
    bounds |= other.bounds;
  }
};

// Of each node, of the pixels where `valid` is not 0.
std::vector<Pixels> PixelsOfNodes(const Trace& trace, const cv::Mat& valid, const cv::Mat& truth) {
  const cv::Mat labels = LabelImage(trace.voxels, trace.segments);
  std::vector<Pixels> pixels(trace.tree.nodes.size());
  for (int row = 0; row < labels.rows; ++row) {
    for (int col = 0; col < labels.cols; ++col) {
      const int label = labels.at<std::uint16_t>(row, col);
      if (label == 0 || valid.at<std::uint8_t>(row, col) == 0) continue;
      Pixels& own = pixels[label - 1];
      ++own.count;
      own.bounds |= cv::Rect(col, row, 1, 1);
      if (!truth.empty()) ++own.of_object[truth.at<std::uint16_t>(row, col)];
    }
  }
  for (std::size_t n = trace.tree.num_segments; n < pixels.size(); ++n) {
    pixels[n].Add(pixels[trace.tree.nodes[n].left]);
    pixels[n].Add(pixels[trace.tree.nodes[n].right]);
  }
  return pixels;
}

double Iou(const cv::Rect& a, const cv::Rect& b) {
  const double common = (a & b).area();
  const double all = a.area() + b.area() - common;
  return all > 0 ? common / all : 0;
}

void ForTreeWithin(const MergeTree& tree, int node, const auto& visit) {
  visit(node);
  if (tree.nodes[node].left < 0) return;
  ForTreeWithin(tree, tree.nodes[node].left, visit);
  ForTreeWithin(tree, tree.nodes[node].right, visit);
}

void ForAllAround(const MergeTree& tree, int node, const auto& visit) {
  for (int n = tree.nodes[node].parent; n >= 0; n = tree.nodes[n].parent) visit(n);
}

std::vector<NodeState> StatesOf(const MergeTree& tree, const std::vector<Overlap>& overlaps) {
  const std::size_t count = tree.nodes.size();
  std::vector<int> by_overlap(count);
  std::iota(by_overlap.begin(), by_overlap.end(), 0);
  std::stable_sort(by_overlap.begin(), by_overlap.end(),
                   [&](int a, int b) { return overlaps[a].iou > overlaps[b].iou; });
  std::vector<int> objects;
  std::vector<char> is_taken(count, 0);
  std::set<int> found;
  for (const int node : by_overlap) {
    const Overlap& overlap = overlaps[node];
    if (overlap.iou <= kRight) break;
    if (is_taken[node] || found.contains(overlap.object)) continue;
    objects.push_back(node);
    found.insert(overlap.object);
    ForTreeWithin(tree, node, [&](int n) { is_taken[n] = 1; });
    ForAllAround(tree, node, [&](int n) { is_taken[n] = 1; });
  }
  std::vector<NodeState> states(count, NodeState::kIsNot);
  std::vector<char> is_optional(count, 0);
  for (std::size_t n = count; n-- > 0;) {
    const int parent = tree.nodes[n].parent;
    is_optional[n] = overlaps[n].is_optional || (parent >= 0 && is_optional[parent]);
    if (is_optional[n] && !is_taken[n]) states[n] = NodeState::kMayBe;
  }
  for (const int node : objects) {
    states[node] = NodeState::kIs;
    ForAllAround(tree, node, [&](int n) {
      const bool is_almost = overlaps[n].iou > std::max(kRight, overlaps[node].iou - kAlmost);
      if (is_almost && overlaps[n].object == overlaps[node].object) states[n] = NodeState::kMayBe;
    });
  }
  return states;
}

TreeSample ToSample(const Trace& trace, const std::vector<Overlap>& overlaps) {
  TreeSample sample{trace.tree, {}, StatesOf(trace.tree, overlaps), 1, true, ""};
  for (const ObjectEvidence& evidence : trace.evidence) sample.terms.push_back(TermsOf(evidence));
  return sample;
}

// Where a mask may be.
cv::Mat SeenArea(const RgbdFrame& frame, const Trace& trace) {
  const cv::Mat measured = frame.depth_m == frame.depth_m;
  return trace.standing.empty() ? measured : measured | trace.standing;
}

}  // namespace

std::string GroupOf(const std::string& source) { return source.substr(0, source.find('_')); }

TreeSample SampleOf(const Scene& scene, const DetectorOptions& options) {
  Trace trace;
  Detect(scene.frame, options, &trace);
  const cv::Mat valid = scene.valid & SeenArea(scene.frame, trace);
  std::map<int, double> size_px;
  for (int row = 0; row < scene.truth.rows; ++row) {
    for (int col = 0; col < scene.truth.cols; ++col) {
      if (scene.valid.at<std::uint8_t>(row, col) == 0) continue;
      ++size_px[scene.truth.at<std::uint16_t>(row, col)];
    }
  }
  std::vector<Overlap> overlaps;
  for (const Pixels& pixels : PixelsOfNodes(trace, valid, scene.truth)) {
    Overlap best;
    for (const auto& [object, common] : pixels.of_object) {
      const double iou = common / (pixels.count + size_px.at(object) - common);
      if (object != 0 && iou > best.iou) best = {iou, object, false};
    }
    overlaps.push_back(best);
  }
  return ToSample(trace, overlaps);
}

TreeSample SampleOf(const BoxedFrame& frame, const DetectorOptions& options) {
  Trace trace;
  Detect(frame.frame, options, &trace);
  std::vector<Overlap> overlaps;
  for (const Pixels& pixels : PixelsOfNodes(trace, SeenArea(frame.frame, trace), {})) {
    Overlap best;
    for (std::size_t i = 0; i < frame.objects.size(); ++i) {
      const double iou = Iou(pixels.bounds, frame.objects[i].box);
      if (frame.objects[i].optional) {
        best.is_optional |= iou > kRight;
      } else if (iou > best.iou) {
        best.iou = iou;
        best.object = static_cast<int>(i);
      }
    }
    overlaps.push_back(best);
  }
  TreeSample sample = ToSample(trace, overlaps);
  sample.group = GroupOf(frame.source);
  return sample;
}

}  // namespace fovea::evaluation
