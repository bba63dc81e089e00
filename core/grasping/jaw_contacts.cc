#include "core/grasping/jaw_contacts.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

namespace fovea {
namespace {

constexpr int kRows = 5;
constexpr std::array kLevels_m = {0.001F, 0.005F, 0.01F, 0.016F, 0.024F, 0.034F};

// One place of a pad and how far out the object reaches before it, along the way towards the
// finger.
struct Reach {
  float across_m, height_m, outwards_m;
};
using Reaches = std::vector<Reach>;  // of one pad

// Through the solid.
std::array<Reaches, 2> ThroughSolid(const TurnedGrid& turned, const CompletedSolid& solid,
                                    const JawPlace& place, const JawGripper& gripper) {
  std::array<Reaches, 2> reaches;
  const Eigen::Vector3f direction(turned.closing.x(), turned.closing.y(), 0);
  for (int i = 0; i < kRows; ++i) {
    const float across =
        place.across_m + (static_cast<float>(i) / (kRows - 1) - 0.5F) * gripper.finger_width_m;
    for (const float level_m : kLevels_m) {
      if (level_m > gripper.finger_length_m) break;
      const float height = place.tip_m + level_m;
      const auto span = solid.Along(turned.ToGrid(0, across, height), direction);
      if (!span) continue;
      reaches[0].push_back({across, height, -span->low});
      reaches[1].push_back({across, height, span->high});
    }
  }
  return reaches;
}

// Through the columns that are higher than each level.
std::array<Reaches, 2> ThroughColumns(const TurnedGrid& turned, const JawPlace& place,
                                      const JawGripper& gripper) {
  std::array<Reaches, 2> reaches;
  for (int row = place.first_row; row <= place.last_row; ++row) {
    const float* heights = turned.TargetRow(row);
    int first = place.first_column, last = place.last_column;
    for (const float level_m : kLevels_m) {
      if (level_m > gripper.finger_length_m) break;
      const float height = place.tip_m + level_m;
      while (first <= last && heights[first] <= height) ++first;
      while (first <= last && heights[last] <= height) --last;
      if (first > last) break;
      const float across = turned.AcrossOf(row);
      reaches[0].push_back({across, height, -turned.AlongOf(static_cast<float>(first) - 0.5F)});
      reaches[1].push_back({across, height, turned.AlongOf(static_cast<float>(last) + 0.5F)});
    }
  }
  return reaches;
}

// Slopes of the plane through what is near the first to touch.
Eigen::Vector2f SlopesOf(const Reaches& touching, const JawPlace& place) {
  constexpr float kRidge = 1e-6F;  // m², for one row or one level
  Eigen::Matrix3f sums = Eigen::Matrix3f::Zero();
  Eigen::Vector3f right = Eigen::Vector3f::Zero();
  for (const Reach& reach : touching) {
    const Eigen::Vector3f row(reach.across_m - place.across_m, reach.height_m - place.tip_m, 1);
    sums += row * row.transpose();
    right += row * reach.outwards_m;
  }
  sums(0, 0) += kRidge;
  sums(1, 1) += kRidge;
  return Eigen::Matrix3f(sums).ldlt().solve(right).head<2>();
}

// `is_exact`: of a solid; then the levels next to the first to touch tell how it slopes even where
// they lie far behind it.
JawContact ContactOf(const Reaches& reaches, const TurnedGrid& turned, const JawPlace& place,
                     float pad_width_m, bool is_towards_plus, float patch_m, bool is_exact) {
  constexpr float kNextLevel_m = 0.0065F;
  JawContact contact;
  Reach first = {0, 0, HandGrid::kNothing};
  for (const Reach& reach : reaches) {
    if (reach.outwards_m > first.outwards_m) first = reach;
  }
  const float farthest = first.outwards_m;
  const float sign = is_towards_plus ? -1.0F : 1.0F;
  constexpr float kFar_m = 1;
  Reaches near;
  Span across = {kFar_m, -kFar_m}, above = {kFar_m, -kFar_m};
  for (const Reach& reach : reaches) {
    const bool is_next = is_exact && reach.across_m == first.across_m &&
                         std::abs(reach.height_m - first.height_m) < kNextLevel_m;
    if (reach.outwards_m < farthest - 2 * patch_m && !is_next) continue;
    near.push_back(reach);
    if (reach.outwards_m < farthest - patch_m) continue;
    const float above_m = reach.height_m - place.tip_m;
    across = {std::min(across.low, reach.across_m), std::max(across.high, reach.across_m)};
    above = {std::min(above.low, above_m), std::max(above.high, above_m)};
    contact.places.push_back(
        turned.ToGrid(sign * reach.outwards_m, reach.across_m, reach.height_m));
  }
  contact.along_m = sign * farthest;
  contact.share = std::clamp((across.high - across.low) / std::max(pad_width_m, 1e-4F), 0.0F, 1.0F);
  contact.across_m = across;
  contact.above_tip_m = above;
  if (near.size() > 2) {
    const Eigen::Vector2f slopes = SlopesOf(near, place);
    contact.slope_across = slopes.x();
    contact.slope_down = slopes.y();
  }
  return contact;
}

// Between them; 0 where they overlap.
float Gap(const Span& a, const Span& b) { return std::max({0.0F, a.low - b.high, b.low - a.high}); }

}  // namespace

Eigen::Vector2f LineBetween(const std::array<JawContact, 2>& contacts, float width_m) {
  const auto& [a, b] = contacts;
  return Eigen::Vector2f(Gap(a.across_m, b.across_m), Gap(a.above_tip_m, b.above_tip_m)) / width_m;
}

std::array<JawContact, 2> CloseOn(const TurnedGrid& turned, const CompletedSolid& solid,
                                  const JawPlace& place, const JawGripper& gripper) {
  constexpr float kPatch_m = 0.002F;
  std::array<Reaches, 2> reaches = ThroughColumns(turned, place, gripper);
  float patch = std::max(kPatch_m, 0.75F * turned.cell_m);
  bool is_exact = false;
  if (solid.IsKnown() && !place.is_part) {
    const auto exact = ThroughSolid(turned, solid, place, gripper);
    const auto farthest = [](const Reaches& side) {
      float most = HandGrid::kNothing;
      for (const Reach& reach : side) most = std::max(most, reach.outwards_m);
      return most;
    };
    bool agrees = true;  // else something sticks out of the solid
    for (const int i : {0, 1}) {
      agrees = agrees && std::abs(farthest(exact[i]) - farthest(reaches[i])) < 2.5F * turned.cell_m;
    }
    if (agrees) {
      is_exact = true;
      reaches = exact;
      patch = kPatch_m;
    }
  }
  std::array<JawContact, 2> contacts;
  for (const int i : {0, 1}) {
    contacts[i] =
        ContactOf(reaches[i], turned, place, gripper.finger_width_m, i == 0, patch, is_exact);
  }
  return contacts;
}

}  // namespace fovea
