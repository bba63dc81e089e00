#include "core/segmentation/stability_merge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <opencv2/imgproc.hpp>
#include <set>
#include <utility>
#include <vector>

#include "core/scene/level_axes.h"
#include "core/segmentation/contacts.h"
#include "core/segmentation/disjoint_sets.h"
#include "core/segmentation/labels.h"
#include "core/segmentation/lower_border.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr int kTouchCells = 2;
constexpr int kMinContacts = 3;       // pairs of voxels
constexpr double kMinFree = 0.5;      // share of a lower border below which one sees farther
constexpr double kRest_m = 0.015;     // above a support, beside its tolerance
constexpr double kMinHeight = 0.4;    // above a support, as a share of its width seen from above
constexpr float kMinDepth_m = 0.05F;  // of a thing whose back is hidden

// Of each label: how many pairs of voxels, by the label that they touch.
using Contacts = std::vector<std::map<int, int>>;

std::vector<cv::Point2f> Hull(const std::vector<cv::Point2f>& places) {
  std::vector<cv::Point2f> hull;
  cv::convexHull(places, hull);
  return hull;
}

struct Segment {
  std::vector<cv::Point2f>
      hull;         // of the places of its voxels on a level plane, to the right and away
  cv::Point2f sum;  // of these places
  int num_voxels = 0;
  float lowest_m = std::numeric_limits<float>::max();  // above its support, less the tolerance
  LowerBorder border;

  void Add(const Segment& other) {
    hull.insert(hull.end(), other.hull.begin(), other.hull.end());
    hull = Hull(hull);
    sum += other.sum;
    num_voxels += other.num_voxels;
    lowest_m = std::min(lowest_m, other.lowest_m);
    border.Add(other.border);
  }
  cv::Point2f Center() const { return sum / static_cast<float>(num_voxels); }
  // One sees past its lower border, and it is so high for its width that nothing hidden below it
  // can carry it.
  bool HangsFree() const {
    if (num_voxels == 0 || border.num_free <= kMinFree * border.num_pixels) return false;
    return lowest_m > std::max(kRest_m, kMinHeight * std::sqrt(cv::contourArea(hull)));
  }
};

Contacts CollectContacts(const VoxelGrid& grid, const std::vector<int>& labels,
                         std::size_t num_segments) {
  Contacts contacts(num_segments);
  for (const VoxelEdge& pair : FindContacts(grid, labels, kTouchCells)) {
    ++contacts[labels[pair.a]][labels[pair.b]];
    ++contacts[labels[pair.b]][labels[pair.a]];
  }
  return contacts;
}

// What a thing covers seen from above; its back, which one does not see, is as far away as it is
// wide.
std::vector<cv::Point2f> Covered(const std::vector<cv::Point2f>& hull) {
  float left = std::numeric_limits<float>::max(), right = -left;
  for (const cv::Point2f& place : hull) {
    left = std::min(left, place.x);
    right = std::max(right, place.x);
  }
  std::vector<cv::Point2f> covered = hull;
  const float depth = std::max(kMinDepth_m, right - left);
  for (const cv::Point2f& place : hull) covered.push_back(place + cv::Point2f(0, depth));
  return covered;
}

// Segments that are joined until none hangs out.
class Statics {
 public:
  Statics(std::vector<Segment> segments, Contacts contacts, double max_overhang_m)
      : segments_(std::move(segments)),
        contacts_(std::move(contacts)),
        max_overhang_m_(max_overhang_m),
        overhangs_m_(segments_.size(), 0) {
    for (int label = 1; label < static_cast<int>(segments_.size()); ++label) Update(label);
  }

  DisjointSets Join() {
    DisjointSets objects(static_cast<int>(segments_.size()));
    while (!unstable_.empty()) {
      InterruptionPoint();
      const int unstable = unstable_.begin()->second;
      const auto holders = HoldersOf(unstable);
      const int holder = std::max_element(holders.begin(), holders.end())->second;
      const auto [into, from] = std::minmax(unstable, holder);
      objects.Join(into, from);
      Join(into, from);
    }
    return objects;
  }

 private:
  // What a segment touches enough to be held by it, and with how many pairs of voxels; what holds
  // something reaches farther down.
  std::vector<std::pair<int, int>> HoldersOf(int label) const {
    std::vector<std::pair<int, int>> holders;
    for (const auto& [other, count] : contacts_[label]) {
      if (count < kMinContacts || segments_[other].lowest_m >= segments_[label].lowest_m) continue;
      holders.emplace_back(count, other);
    }
    return holders;
  }

  // How far the centre of a segment is beside all that it touches; below 0 if it is above.
  double Overhang(int label) const {
    std::vector<cv::Point2f> below;
    for (const auto& [count, holder] : HoldersOf(label)) {
      const std::vector<cv::Point2f> covered = Covered(segments_[holder].hull);
      below.insert(below.end(), covered.begin(), covered.end());
    }
    if (below.size() < 3) return 0;
    return -cv::pointPolygonTest(Hull(below), segments_[label].Center(), true);
  }

  void Update(int label) {
    unstable_.erase({-overhangs_m_[label], label});
    overhangs_m_[label] = segments_[label].HangsFree() ? Overhang(label) : 0;
    if (overhangs_m_[label] > max_overhang_m_) unstable_.emplace(-overhangs_m_[label], label);
  }

  void Join(int into, int from) {
    segments_[into].Add(segments_[from]);
    segments_[from] = {};
    for (const auto& [other, count] : std::exchange(contacts_[from], {})) {
      contacts_[other].erase(from);
      if (other == into) continue;
      contacts_[into][other] += count;
      contacts_[other][into] += count;
    }
    Update(from);
    Update(into);
    for (const auto& [other, count] : contacts_[into]) Update(other);
  }

  std::vector<Segment> segments_;
  Contacts contacts_;
  const double max_overhang_m_;
  std::vector<double> overhangs_m_;            // of each label; 0 unless it hangs free
  std::set<std::pair<double, int>> unstable_;  // less the overhang, label: the largest one first
};

std::vector<Segment> CollectSegments(const VoxelGrid& grid, const std::vector<int>& labels,
                                     const std::vector<Support>& supports,
                                     const SupportOptions& options, const Eigen::Vector3f& up) {
  const LevelAxes axes = LevelAxesAlongView(up);
  std::vector<Segment> segments(CountLabels(labels) + 1);
  std::vector<std::vector<cv::Point2f>> places(segments.size());
  for (std::size_t v = 0; v < labels.size(); ++v) {
    if (labels[v] == 0) continue;
    const Eigen::Vector3f& point = grid.voxels[v].mean;
    Segment& segment = segments[labels[v]];
    const Eigen::Vector2f on_plane = axes * point;
    const cv::Point2f place(on_plane.x(), on_plane.y());
    places[labels[v]].push_back(place);
    segment.sum += place;
    ++segment.num_voxels;
    const auto below = SupportBelow(supports, point, options);
    if (!below) continue;
    const float height_m = supports[*below].surface.HeightOf(point);
    segment.lowest_m = std::min(segment.lowest_m, height_m - SupportTolerance(point.z(), options));
  }
  for (std::size_t label = 1; label < segments.size(); ++label) {
    InterruptionPoint();
    segments[label].hull = Hull(places[label]);
  }
  return segments;
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
  Contacts contacts = CollectContacts(grid, labels, segments.size());
  DisjointSets objects =
      Statics(std::move(segments), std::move(contacts), options.max_overhang_m).Join();
  return Renumbered(labels, objects);
}

}  // namespace fovea
