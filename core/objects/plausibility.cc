#include "core/objects/plausibility.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/objects/furniture.h"
#include "core/objects/oriented_box.h"
#include "core/objects/placed_segment.h"
#include "core/segmentation/contacts.h"
#include "core/segmentation/labels.h"
#include "core/types/interruption.h"
#include "core/types/pixels.h"

namespace fovea {
namespace {

constexpr float kMinBack_m = 0.3F;  // width of the back of a chair
constexpr int kTouchCells = 2;      // between segments that touch

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

// Whether it matters what touches what.
bool MatterContacts(const std::vector<PlacedSegment>& segments, const std::vector<char>& seats,
                    const PlausibilityOptions& options) {
  if (std::count(seats.begin(), seats.end(), 1) > 0) return true;
  return std::any_of(segments.begin() + 1, segments.end(), [&](const PlacedSegment& segment) {
    return segment.lowest_m > options.max_rest_m;
  });
}

// Segments that touch one that rests, directly or through others, rest too.
void SpreadRest(const std::vector<int>& labels, const std::vector<VoxelEdge>& contacts,
                const std::vector<char>& stays, std::vector<char>& rests) {
  for (bool changed = true; changed;) {
    InterruptionPoint();
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
  const std::vector<char> table_legs = FindTableLegs(segments, up, options.max_hang_m);
  const std::vector<char> seats =
      FindSeats(segments, LabelImage(grid, labels), points, intrinsics, up, options.max_height_m);
  std::vector<VoxelEdge> contacts;
  if (MatterContacts(segments, seats, options)) contacts = FindContacts(grid, labels, kTouchCells);
  const std::vector<char> seat_legs = FindLegsOf(seats, segments, labels, contacts, up);
  std::vector<char> stays(segments.size(), 0);
  std::vector<char> rests(segments.size(), 0);
  for (std::size_t label = 1; label < segments.size(); ++label) {
    InterruptionPoint();
    stays[label] = !table_legs[label] && !seats[label] && !seat_legs[label] &&
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
