#include "core/grasping/jaw_contacts.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace fovea {
namespace {

constexpr int kRows = 5;
constexpr std::array kLevels_m = {0.001F, 0.005F, 0.01F, 0.016F, 0.024F, 0.034F};

float Farthest(const std::vector<PadReach>& reaches) {
  float most = HandGrid::kNothing;
  for (const PadReach& reach : reaches) most = std::max(most, reach.outwards_m);
  return most;
}

// Slopes of the plane through what is near the first to touch.
Eigen::Vector2f SlopesOf(const std::vector<PadReach>& touching, const JawPlace& place) {
  constexpr float kRidge = 1e-6F;  // m², for one row or one level
  Eigen::Matrix3f sums = Eigen::Matrix3f::Zero();
  Eigen::Vector3f right = Eigen::Vector3f::Zero();
  for (const PadReach& reach : touching) {
    const Eigen::Vector3f row(reach.across_m - place.across_m, reach.height_m - place.tip_m, 1);
    sums += row * row.transpose();
    right += row * reach.outwards_m;
  }
  sums(0, 0) += kRidge;
  sums(1, 1) += kRidge;
  return Eigen::Matrix3f(sums).ldlt().solve(right).head<2>();
}

// Between them; 0 where they overlap.
float Gap(const Span& a, const Span& b) { return std::max({0.0F, a.low - b.high, b.low - a.high}); }

}  // namespace

Eigen::Vector2f LineBetween(const std::array<JawContact, 2>& contacts, float width_m) {
  const auto& [a, b] = contacts;
  return Eigen::Vector2f(Gap(a.across_m, b.across_m), Gap(a.above_tip_m, b.above_tip_m)) / width_m;
}

JawCloser::JawCloser(const TurnedGrid& turned, const CompletedSolid& solid,
                     const JawGripper& gripper)
    : turned_(turned), solid_(solid), gripper_(gripper) {}

void JawCloser::ReachThroughSolid(const JawPlace& place) {
  const Eigen::Vector3f direction(turned_.closing.x(), turned_.closing.y(), 0);
  lines_.Clear();
  pad_.clear();
  for (int i = 0; i < kRows; ++i) {
    const float across =
        place.across_m + (static_cast<float>(i) / (kRows - 1) - 0.5F) * gripper_.finger_width_m;
    for (const float level_m : kLevels_m) {
      if (level_m > gripper_.finger_length_m) break;
      const float height = place.tip_m + level_m;
      lines_.Add(turned_.ToGrid(0, across, height), direction);
      pad_.push_back({across, height, 0});
    }
  }
  solid_.Along(lines_, spans_);
  for (Reaches& reaches : of_solid_) reaches.clear();
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    if (spans_[i].IsEmpty()) continue;
    of_solid_[0].push_back({pad_[i].across_m, pad_[i].height_m, -spans_[i].low});
    of_solid_[1].push_back({pad_[i].across_m, pad_[i].height_m, spans_[i].high});
  }
}

// Those that are higher than each level.
void JawCloser::ReachThroughColumns(const JawPlace& place) {
  for (Reaches& reaches : of_columns_) reaches.clear();
  for (int row = place.first_row; row <= place.last_row; ++row) {
    const float* heights = turned_.TargetRow(row);
    int first = place.first_column, last = place.last_column;
    for (const float level_m : kLevels_m) {
      if (level_m > gripper_.finger_length_m) break;
      const float height = place.tip_m + level_m;
      while (first <= last && heights[first] <= height) ++first;
      while (first <= last && heights[last] <= height) --last;
      if (first > last) break;
      const float across = turned_.AcrossOf(row);
      of_columns_[0].push_back(
          {across, height, -turned_.AlongOf(static_cast<float>(first) - 0.5F)});
      of_columns_[1].push_back({across, height, turned_.AlongOf(static_cast<float>(last) + 0.5F)});
    }
  }
}

// Else something sticks out of the solid.
bool JawCloser::AgreeWithColumns() const {
  const auto agree = [&](int i) {
    return std::abs(Farthest(of_solid_[i]) - Farthest(of_columns_[i])) < 2.5F * turned_.cell_m;
  };
  return agree(0) && agree(1);
}

// `is_exact`: of a solid; then the levels and rows next to the first to touch tell how it slopes
// even where they lie far behind it. `sign`: of where the finger comes from, against closing.
void JawCloser::SetContact(const Reaches& reaches, const JawPlace& place, float sign, float patch_m,
                           bool is_exact, JawContact& contact) {
  constexpr float kNextLevel_m = 0.0065F;
  PadReach first = {0, 0, HandGrid::kNothing};
  for (const PadReach& reach : reaches) {
    if (reach.outwards_m > first.outwards_m) first = reach;
  }
  const float farthest = first.outwards_m;
  const float next_row_m = 1.3F * gripper_.finger_width_m / (kRows - 1);
  constexpr float kFar_m = 1;
  Span across = {kFar_m, -kFar_m}, above = {kFar_m, -kFar_m};
  contact.places.clear();
  near_.clear();
  for (const PadReach& reach : reaches) {
    const bool is_next_level = reach.across_m == first.across_m &&
                               std::abs(reach.height_m - first.height_m) < kNextLevel_m;
    const bool is_next_row =
        reach.height_m == first.height_m && std::abs(reach.across_m - first.across_m) < next_row_m;
    const bool is_next = is_exact && (is_next_level || is_next_row);
    if (reach.outwards_m < farthest - 2 * patch_m && !is_next) continue;
    near_.push_back(reach);
    if (reach.outwards_m < farthest - patch_m) continue;
    const float above_m = reach.height_m - place.tip_m;
    across = {std::min(across.low, reach.across_m), std::max(across.high, reach.across_m)};
    above = {std::min(above.low, above_m), std::max(above.high, above_m)};
    contact.places.push_back(
        turned_.ToGrid(sign * reach.outwards_m, reach.across_m, reach.height_m));
  }
  contact.is_exact = is_exact;
  contact.along_m = sign * farthest;
  contact.share =
      std::clamp((across.high - across.low) / std::max(gripper_.finger_width_m, 1e-4F), 0.0F, 1.0F);
  contact.across_m = across;
  contact.above_tip_m = above;
  const Eigen::Vector2f slopes =
      near_.size() > 2 ? SlopesOf(near_, place) : Eigen::Vector2f(Eigen::Vector2f::Zero());
  contact.slope_across = slopes.x();
  contact.slope_down = slopes.y();
}

const std::array<JawContact, 2>& JawCloser::CloseOn(const JawPlace& place) {
  constexpr float kPatch_m = 0.002F;
  ReachThroughColumns(place);
  bool is_exact = solid_.IsKnown() && !place.is_part;
  if (is_exact) {
    ReachThroughSolid(place);
    is_exact = AgreeWithColumns();
  }
  const float patch = is_exact ? kPatch_m : std::max(kPatch_m, 0.75F * turned_.cell_m);
  const std::array<Reaches, 2>& reaches = is_exact ? of_solid_ : of_columns_;
  SetContact(reaches[0], place, -1, patch, is_exact, contacts_[0]);
  SetContact(reaches[1], place, 1, patch, is_exact, contacts_[1]);
  return contacts_;
}

}  // namespace fovea
