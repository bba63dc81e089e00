#include "core/objects/furniture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <set>
#include <utility>

#include "core/scene/level_axes.h"
#include "core/segmentation/lower_border.h"

namespace fovea {
namespace {

constexpr float kLegMargin_m = 0.04F;  // between what is seen of one leg
constexpr float kLifted_m = 0.1F;      // above a support, beyond what noise hides

// Most of it lies under a support.
bool IsCovered(const PlacedSegment& segment) {
  return 2 * segment.num_covered > segment.points.size();
}

Eigen::AlignedBox2f SeenFromAbove(const PlacedSegment& segment, const LevelAxes& axes) {
  Eigen::AlignedBox2f box;
  for (const Eigen::Vector3f& point : segment.points) box.extend(Eigen::Vector2f(axes * point));
  return box;
}

Eigen::AlignedBox2f WithMargin(Eigen::AlignedBox2f box) {
  box.min().array() -= kLegMargin_m;
  box.max().array() += kLegMargin_m;
  return box;
}

}  // namespace

std::vector<char> FindTableLegs(const std::vector<PlacedSegment>& segments,
                                const Eigen::Vector3f& up, double max_hang_m) {
  const LevelAxes axes = LevelAxesFor(up);
  std::vector<char> hang(segments.size(), 0);
  std::vector<Eigen::AlignedBox2f> legs;
  for (std::size_t label = 1; label < segments.size(); ++label) {
    const PlacedSegment& segment = segments[label];
    if (!IsCovered(segment) || segment.least_depth_m >= max_hang_m) continue;
    hang[label] = 1;
    legs.push_back(WithMargin(SeenFromAbove(segment, axes)));
  }
  for (std::size_t label = 1; label < segments.size(); ++label) {
    if (hang[label] || !IsCovered(segments[label])) continue;
    const Eigen::AlignedBox2f box = SeenFromAbove(segments[label], axes);
    hang[label] = std::any_of(legs.begin(), legs.end(),
                              [&](const Eigen::AlignedBox2f& leg) { return leg.contains(box); });
  }
  return hang;
}

std::vector<char> FindSeats(const std::vector<PlacedSegment>& segments, const cv::Mat& labels,
                            const cv::Mat& points, const CameraIntrinsics& intrinsics,
                            const Eigen::Vector3f& up, double max_height_m) {
  std::vector<char> seats(segments.size(), 0);
  for (std::size_t label = 1; label < segments.size(); ++label) {
    const PlacedSegment& segment = segments[label];
    seats[label] = segment.lowest_m > kLifted_m && segment.highest_m > max_height_m;
  }
  if (std::count(seats.begin(), seats.end(), 1) == 0) return seats;
  const std::vector<LowerBorder> borders = FindLowerBorders(labels, points, intrinsics, up, seats);
  for (std::size_t label = 1; label < segments.size(); ++label) {
    const LowerBorder& border = borders[label];
    if (2 * (border.num_free + border.num_hidden) <= border.num_pixels) seats[label] = 0;
  }
  return seats;
}

std::vector<char> FindLegsOf(const std::vector<char>& seats,
                             const std::vector<PlacedSegment>& segments,
                             const std::vector<int>& labels, const std::vector<VoxelEdge>& contacts,
                             const Eigen::Vector3f& up) {
  std::set<std::pair<int, int>> below;  // a seat, and what touches it and begins lower
  const auto consider = [&](int seat, int leg) {
    const bool is_lower = segments[leg].lowest_m < segments[seat].lowest_m;
    if (seats[seat] && !seats[leg] && is_lower) below.emplace(seat, leg);
  };
  for (const VoxelEdge& contact : contacts) {
    consider(labels[contact.a], labels[contact.b]);
    consider(labels[contact.b], labels[contact.a]);
  }
  const LevelAxes axes = LevelAxesFor(up);
  std::vector<char> legs(segments.size(), 0);
  for (const auto& [seat, leg] : below) {
    const Eigen::AlignedBox2f box = WithMargin(SeenFromAbove(segments[seat], axes));
    if (box.contains(SeenFromAbove(segments[leg], axes))) legs[leg] = 1;
  }
  return legs;
}

}  // namespace fovea
