#include "core/objects/plausibility.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <utility>

#include "core/objects/oriented_box.h"
#include "core/objects/placed_segment.h"
#include "core/scene/level_axes.h"
#include "core/segmentation/contacts.h"
#include "core/segmentation/labels.h"
#include "core/segmentation/lower_border.h"
#include "core/types/pixels.h"

namespace fovea {
namespace {

constexpr float kMinBack_m = 0.3F;     // width of the back of a chair
constexpr float kLegMargin_m = 0.04F;  // between what is seen of one leg
constexpr int kTouchCells = 2;         // between segments that touch
constexpr float kLifted_m = 0.1F;      // above a support, beyond what noise hides

// The area of what a segment stands on; none where that is unbounded, or the largest part of the
// dominating surface, much of which may hide.
std::optional<double> AreaOfItsSupportM2(const PlacedSegment& segment,
                                         const std::vector<Support>& supports) {
  const auto most =
      std::max_element(segment.num_above.begin(), segment.num_above.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most == segment.num_above.end()) return std::nullopt;
  const auto& [support, part] = most->first;
  const std::vector<double>& areas = supports[support].footprint.PartAreasM2();
  if (areas.empty()) return std::nullopt;
  const double largest = *std::max_element(areas.begin(), areas.end());
  if (support == 0 && areas[part] == largest) return std::nullopt;
  return areas[part];
}

// As large as what it stands on.
bool IsPartOfItsSupport(const PlacedSegment& segment, const Eigen::Vector3f& size_m,
                        const std::vector<Support>& supports, double max_support_share) {
  const float width_m = size_m.head<2>().maxCoeff();
  if (width_m < kMinBack_m) return false;
  const std::optional<double> area_m2 = AreaOfItsSupportM2(segment, supports);
  return area_m2 && width_m * size_m.z() > max_support_share * *area_m2;
}

bool IsTooLarge(const PlacedSegment& segment, const std::vector<Support>& supports,
                const PlausibilityOptions& options) {
  const Eigen::Vector3f up = supports.front().surface.normal;
  const Eigen::Vector3f size_m = FitOrientedBox(segment.points, up, std::nullopt).size_m;
  return size_m.maxCoeff() > options.max_size_m || size_m.z() > options.max_height_m ||
         IsPartOfItsSupport(segment, size_m, supports, options.max_support_share);
}

// So little, so close above the surface, that it may be noise, whose patches have as many pixels in
// the images of a small sensor.
bool IsLump(const PlacedSegment& segment, const cv::Size& image,
            const PlausibilityOptions& options) {
  constexpr float kLowRise = 2;
  const double scale = std::max(1.0, AreaScale(image));
  return segment.rise < kLowRise && segment.num_pixels < scale * options.min_low_pixels;
}

// Most of it lies under a support.
bool IsCovered(const PlacedSegment& segment) {
  return 2 * segment.num_covered > segment.points.size();
}

Eigen::AlignedBox2f SeenFromAbove(const PlacedSegment& segment, const LevelAxes& axes) {
  Eigen::AlignedBox2f box;
  for (const Eigen::Vector3f& point : segment.points) box.extend(Eigen::Vector2f(axes * point));
  return box;
}

// Segments that reach up to a support that covers them, and what is covered and stands right below
// one of them: the lower end of a leg.
std::vector<char> FindHanging(const std::vector<PlacedSegment>& segments, const Eigen::Vector3f& up,
                              double max_hang_m) {
  const LevelAxes axes = LevelAxesFor(up);
  std::vector<char> hang(segments.size(), 0);
  std::vector<Eigen::AlignedBox2f> legs;
  for (std::size_t label = 1; label < segments.size(); ++label) {
    const PlacedSegment& segment = segments[label];
    if (!IsCovered(segment) || segment.least_depth_m >= max_hang_m) continue;
    hang[label] = 1;
    Eigen::AlignedBox2f& leg = legs.emplace_back(SeenFromAbove(segment, axes));
    leg.min().array() -= kLegMargin_m;
    leg.max().array() += kLegMargin_m;
  }
  for (std::size_t label = 1; label < segments.size(); ++label) {
    if (hang[label] || !IsCovered(segments[label])) continue;
    const Eigen::AlignedBox2f box = SeenFromAbove(segments[label], axes);
    hang[label] = std::any_of(legs.begin(), legs.end(),
                              [&](const Eigen::AlignedBox2f& leg) { return leg.contains(box); });
  }
  return hang;
}

// Segments high above their support that end higher than an object can, where nothing is seen right
// below them: something in front hides it, or one sees past.
std::vector<char> FindTooHigh(const std::vector<PlacedSegment>& segments, const cv::Mat& labels,
                              const cv::Mat& points, const CameraIntrinsics& intrinsics,
                              const Eigen::Vector3f& up, double max_height_m) {
  std::vector<char> too_high(segments.size(), 0);
  for (std::size_t label = 1; label < segments.size(); ++label) {
    const PlacedSegment& segment = segments[label];
    too_high[label] = segment.lowest_m > kLifted_m && segment.highest_m > max_height_m;
  }
  if (std::count(too_high.begin(), too_high.end(), 1) == 0) return too_high;
  const std::vector<LowerBorder> borders =
      FindLowerBorders(labels, points, intrinsics, up, too_high);
  for (std::size_t label = 1; label < segments.size(); ++label) {
    const LowerBorder& border = borders[label];
    if (2 * (border.num_free + border.num_hidden) <= border.num_pixels) too_high[label] = 0;
  }
  return too_high;
}

// Adds what touches a segment that is too high from below, and nothing beside it: its legs.
void AddLegs(const std::vector<PlacedSegment>& segments, const std::vector<int>& labels,
             const std::vector<VoxelEdge>& contacts, const Eigen::Vector3f& up,
             std::vector<char>& too_high) {
  const LevelAxes axes = LevelAxesFor(up);
  const std::vector<char> seats = too_high;
  const auto add = [&](int leg, int seat) {
    if (!seats[seat] || too_high[leg] || segments[leg].lowest_m >= segments[seat].lowest_m) return;
    Eigen::AlignedBox2f box = SeenFromAbove(segments[seat], axes);
    box.min().array() -= kLegMargin_m;
    box.max().array() += kLegMargin_m;
    too_high[leg] = box.contains(SeenFromAbove(segments[leg], axes)) ? 1 : 0;
  };
  for (const VoxelEdge& contact : contacts) {
    add(labels[contact.a], labels[contact.b]);
    add(labels[contact.b], labels[contact.a]);
  }
}

// Whether it matters what touches what.
bool MatterContacts(const std::vector<PlacedSegment>& segments, const std::vector<char>& too_high,
                    const PlausibilityOptions& options) {
  if (std::count(too_high.begin(), too_high.end(), 1) > 0) return true;
  return std::any_of(segments.begin() + 1, segments.end(), [&](const PlacedSegment& segment) {
    return segment.lowest_m > options.max_rest_m;
  });
}

// Segments that touch one that rests, directly or through others, rest too.
void SpreadRest(const std::vector<int>& labels, const std::vector<VoxelEdge>& contacts,
                const std::vector<char>& stays, std::vector<char>& rests) {
  for (bool changed = true; changed;) {
    changed = false;
    for (const VoxelEdge& contact : contacts) {
      const int a = labels[contact.a];
      const int b = labels[contact.b];
      if (!stays[a] || !stays[b] || rests[a] == rests[b]) continue;
      rests[a] = rests[b] = 1;
      changed = true;
    }
  }
}

}  // namespace

PlausibleSegments RemoveImplausible(const VoxelGrid& grid, const std::vector<int>& labels,
                                    const cv::Mat& points, const CameraIntrinsics& intrinsics,
                                    const std::vector<Support>& supports,
                                    const SupportOptions& support_options,
                                    const PlausibilityOptions& options) {
  PlausibleSegments result{labels, 0};
  if (supports.empty()) return result;
  const std::vector<PlacedSegment> segments =
      PlaceSegments(grid, labels, supports, support_options);
  const Eigen::Vector3f& up = supports.front().surface.normal;
  const std::vector<char> hang = FindHanging(segments, up, options.max_hang_m);
  std::vector<char> too_high =
      FindTooHigh(segments, LabelImage(grid, labels), points, intrinsics, up, options.max_height_m);
  std::vector<VoxelEdge> contacts;
  if (MatterContacts(segments, too_high, options)) {
    contacts = FindContacts(grid, labels, kTouchCells);
  }
  AddLegs(segments, labels, contacts, up, too_high);
  std::vector<char> stays(segments.size(), 0);
  std::vector<char> rests(segments.size(), 0);
  for (std::size_t label = 1; label < segments.size(); ++label) {
    stays[label] = !hang[label] && !too_high[label] &&
                   !IsTooLarge(segments[label], supports, options) &&
                   !IsLump(segments[label], points.size(), options);
    rests[label] = segments[label].lowest_m <= options.max_rest_m;
  }
  SpreadRest(labels, contacts, stays, rests);
  for (std::size_t label = 1; label < segments.size(); ++label) {
    if (!stays[label] || !rests[label]) ++result.num_removed;
  }
  for (int& label : result.labels) {
    if (label != 0 && !(stays[label] && rests[label])) label = 0;
  }
  return result;
}

}  // namespace fovea
