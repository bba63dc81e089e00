#include "core/segmentation/stability_merge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/segmentation/contacts.h"
#include "core/segmentation/disjoint_sets.h"
#include "core/segmentation/labels.h"
#include "core/segmentation/lower_border.h"

namespace fovea {
namespace {

constexpr int kTouchCells = 2;
constexpr int kMinContacts = 3;       // pairs of voxels
constexpr double kMinFree = 0.5;      // share of a lower border below which one sees farther
constexpr double kRest_m = 0.015;     // above a support, beside its tolerance
constexpr double kMinHeight = 0.4;    // above a support, as a share of its width seen from above
constexpr float kMinDepth_m = 0.05F;  // of a thing whose back is hidden

using Contacts = std::map<std::pair<int, int>, int>;  // pairs of voxels by pair of labels

// The horizontal plane, in coordinates of two axes of which the second leads away from the camera.
struct HorizontalPlane {
  Eigen::Vector3f right;
  Eigen::Vector3f away;

  explicit HorizontalPlane(const Eigen::Vector3f& up) {
    const Eigen::Vector3f ahead = Eigen::Vector3f::UnitZ() - up.z() * up;
    away = ahead.norm() > 0.1F ? ahead.normalized() : up.unitOrthogonal();
    right = away.cross(up);
  }
  cv::Point2f Project(const Eigen::Vector3f& p) const { return {right.dot(p), away.dot(p)}; }
};

struct Segment {
  std::vector<cv::Point2f> places;  // of its voxels, in the horizontal plane
  cv::Point2f sum;
  float lowest_m = std::numeric_limits<float>::max();  // above its support, less the tolerance
  LowerBorder border;

  void Add(const Segment& other) {
    places.insert(places.end(), other.places.begin(), other.places.end());
    sum += other.sum;
    lowest_m = std::min(lowest_m, other.lowest_m);
    border.Add(other.border);
  }
  cv::Point2f Center() const { return sum / static_cast<float>(places.size()); }
  // One sees past its lower border, and it is so high for its width that nothing hidden below it
  // can carry it.
  bool HangsFree() const {
    if (places.empty() || border.num_free <= kMinFree * border.num_pixels) return false;
    std::vector<cv::Point2f> hull;
    cv::convexHull(places, hull);
    return lowest_m > std::max(kRest_m, kMinHeight * std::sqrt(cv::contourArea(hull)));
  }
};

Contacts CollectContacts(const VoxelGrid& grid, const std::vector<int>& labels) {
  Contacts contacts;
  for (const VoxelEdge& pair : FindContacts(grid, labels, kTouchCells)) {
    const auto [low, high] = std::minmax(labels[pair.a], labels[pair.b]);
    ++contacts[{low, high}];
  }
  return contacts;
}

// What a thing covers seen from above; its back, which one does not see, is as far away as it is
// wide.
std::vector<cv::Point2f> Covered(const std::vector<cv::Point2f>& places) {
  float left = std::numeric_limits<float>::max(), right = -left;
  for (const cv::Point2f& place : places) {
    left = std::min(left, place.x);
    right = std::max(right, place.x);
  }
  std::vector<cv::Point2f> covered = places;
  const float depth = std::max(kMinDepth_m, right - left);
  for (const cv::Point2f& place : places) covered.push_back(place + cv::Point2f(0, depth));
  return covered;
}

// What a segment touches enough to be held by it, and with how many pairs of voxels; what holds
// something reaches farther down.
std::vector<std::pair<int, int>> HoldersOf(int label, const std::vector<Segment>& segments,
                                           const Contacts& contacts) {
  std::vector<std::pair<int, int>> holders;
  for (const auto& [pair, count] : contacts) {
    if ((pair.first != label && pair.second != label) || count < kMinContacts) continue;
    const int other = pair.first == label ? pair.second : pair.first;
    if (segments[other].lowest_m < segments[label].lowest_m) holders.emplace_back(count, other);
  }
  return holders;
}

// How far the centre of a segment is beside all that it touches; below 0 if it is above.
double Overhang(int label, const std::vector<Segment>& segments, const Contacts& contacts) {
  std::vector<cv::Point2f> below;
  for (const auto& [count, holder] : HoldersOf(label, segments, contacts)) {
    const std::vector<cv::Point2f> covered = Covered(segments[holder].places);
    below.insert(below.end(), covered.begin(), covered.end());
  }
  if (below.size() < 3) return 0;
  std::vector<cv::Point2f> hull;
  cv::convexHull(below, hull);
  return -cv::pointPolygonTest(hull, segments[label].Center(), true);
}

void JoinContacts(Contacts& contacts, int into, int from) {
  Contacts joined;
  for (const auto& [pair, count] : contacts) {
    const int a = pair.first == from ? into : pair.first;
    const int b = pair.second == from ? into : pair.second;
    if (a != b) joined[std::minmax(a, b)] += count;
  }
  contacts = std::move(joined);
}

std::vector<Segment> CollectSegments(const VoxelGrid& grid, const std::vector<int>& labels,
                                     const std::vector<Support>& supports,
                                     const SupportOptions& options, const Eigen::Vector3f& up) {
  const HorizontalPlane plane(up);
  std::vector<Segment> segments(CountLabels(labels) + 1);
  for (std::size_t v = 0; v < labels.size(); ++v) {
    if (labels[v] == 0) continue;
    const Eigen::Vector3f& point = grid.voxels[v].mean;
    Segment& segment = segments[labels[v]];
    segment.places.push_back(plane.Project(point));
    segment.sum += segment.places.back();
    const auto below = SupportBelow(supports, point, options);
    if (!below) continue;
    const float height_m = supports[*below].surface.HeightOf(point);
    segment.lowest_m = std::min(segment.lowest_m, height_m - SupportTolerance(point.z(), options));
  }
  return segments;
}

// The segment that hangs out farthest, if by more than `max_overhang_m`, and what holds it; 0 if
// there is none.
std::pair<int, int> MostUnstable(const std::vector<Segment>& segments, const Contacts& contacts,
                                 double max_overhang_m) {
  int unstable = 0;
  double largest_m = max_overhang_m;
  for (int label = 1; label < static_cast<int>(segments.size()); ++label) {
    if (!segments[label].HangsFree()) continue;
    const double overhang_m = Overhang(label, segments, contacts);
    if (overhang_m <= largest_m) continue;
    largest_m = overhang_m;
    unstable = label;
  }
  if (unstable == 0) return {0, 0};
  const auto holders = HoldersOf(unstable, segments, contacts);
  return {unstable, std::max_element(holders.begin(), holders.end())->second};
}

}  // namespace

std::vector<int> MergeUnstable(const VoxelGrid& grid, const std::vector<int>& labels,
                               const cv::Mat& points, const CameraIntrinsics& intrinsics,
                               const std::vector<Support>& supports,
                               const SupportOptions& support_options, const Eigen::Vector3f& up,
                               const StabilityMergeOptions& options) {
  if (options.max_overhang_m <= 0 || supports.empty()) return labels;
  std::vector<Segment> segments = CollectSegments(grid, labels, supports, support_options, up);
  std::vector<char> is_high;
  is_high.reserve(segments.size());
  for (const Segment& segment : segments) is_high.push_back(segment.lowest_m > kRest_m ? 1 : 0);
  const auto borders = FindLowerBorders(LabelImage(grid, labels), points, intrinsics, up, is_high);
  for (std::size_t label = 1; label < segments.size(); ++label) {
    segments[label].border = borders[label];
  }
  const bool any_hangs = std::any_of(segments.begin() + 1, segments.end(),
                                     [](const Segment& segment) { return segment.HangsFree(); });
  if (!any_hangs) return labels;
  Contacts contacts = CollectContacts(grid, labels);
  DisjointSets objects(static_cast<int>(segments.size()));
  while (true) {
    const auto [unstable, holder] = MostUnstable(segments, contacts, options.max_overhang_m);
    if (unstable == 0) break;
    const int into = std::min(unstable, holder);
    const int from = std::max(unstable, holder);
    objects.Join(into, from);
    segments[into].Add(segments[from]);
    segments[from] = {};
    JoinContacts(contacts, into, from);
  }
  return Renumbered(labels, objects);
}

}  // namespace fovea
