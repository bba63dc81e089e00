#include "core/grasping/jaw_places.h"

#include <algorithm>
#include <cmath>

namespace fovea {
namespace {

using Reason = NoGrasp::Reason;

constexpr float kMargin_m = 0.002F;  // to what was seen
constexpr float kAboveFloor_m = 0.003F;
constexpr float kFarthestTold_m = 0.02F;   // to which distances are told
constexpr float kMostRoom_m = 0.02F;       // to open wider than what is needed, in whole cells,
constexpr float kMostWithCell_m = 0.025F;  // and with what the last of these is more
constexpr float kLeastGrip_m = 0.004F;     // of the fingers below the object's top
constexpr std::size_t kMostRuns = 4;

struct Run {
  int first = 0, last = 0;
};

// One place across the object: what is before the fingers, and under the palm.
struct Station {
  const HandGrid& grid;
  const TurnedGrid& turned;
  const JawGripper& gripper;
  int first_row, last_row;
  float across_m;
  Strip pads, palm;

  int CellsIn(float length_m) const { return static_cast<int>(std::ceil(length_m / grid.cell_m)); }
  float FloorAtMiddle() const {
    const Eigen::Vector3f middle = turned.ToGrid(0, across_m, 0);
    return grid.FloorAt(middle.x(), middle.y());
  }
};

float Highest(const std::vector<float>& heights, int first, int last) {
  first = std::max(first, 0);
  last = std::min(last, static_cast<int>(heights.size()) - 1);
  float highest = HandGrid::kNothing;
  for (int c = first; c <= last; ++c)
    highest = std::max(highest, heights[static_cast<std::size_t>(c)]);
  return highest;
}

// Parts of the object above the tips between which a finger may fit.
std::vector<Run> RunsAbove(const Station& at, float tip_m) {
  const int gap = at.CellsIn(at.gripper.finger_thickness_m);
  std::vector<Run> runs;
  const int columns = static_cast<int>(at.pads.target.size());
  for (int c = 0; c < columns; ++c) {
    if (at.pads.target[static_cast<std::size_t>(c)] <= tip_m) continue;
    if (runs.empty() || c - runs.back().last > gap) {
      runs.push_back({c, c});
    } else {
      runs.back().last = c;
    }
  }
  return runs;
}

float TopOf(const Strip& strip) {
  return *std::max_element(strip.target.begin(), strip.target.end());
}

// Heights of the tips to try: as deep as palm and floor let them, and less deep.
std::vector<float> TipHeights(const Station& at) {
  const float top = TopOf(at.pads);
  const float under_palm = TopOf(at.palm);
  const float floor = at.FloorAtMiddle();
  const float lowest =
      std::max(floor + kAboveFloor_m, under_palm - at.gripper.finger_length_m + 2 * kMargin_m);
  std::vector<float> heights;
  for (const float depth_m : {at.gripper.finger_length_m, 0.025F, 0.014F, 0.007F, 0.005F}) {
    const float height = std::max(lowest, top - depth_m);
    if (top - height < kLeastGrip_m) continue;
    if (heights.empty() || height - heights.back() > kMargin_m) heights.push_back(height);
  }
  return heights;
}

// Why there is no height for the tips: too little of it is above the floor or, whatever it stands
// on, the palm comes first.
Reason WhyNoHeight(const Station& at) {
  const float reach = TopOf(at.pads) - at.FloorAtMiddle() - kAboveFloor_m;
  return reach < kLeastGrip_m ? Reason::kTooLow : Reason::kUnlikely;
}

// Up to how many cells beyond `column`, in steps of `step`, nothing reaches up to the tips.
int FreeCells(const Station& at, int column, int step, float tip_m, int most) {
  const int columns = static_cast<int>(at.pads.target.size());
  for (int i = 1; i <= most; ++i) {
    const int c = column + i * step;
    if (c < 0 || c >= columns) return most;
    const auto k = static_cast<std::size_t>(c);
    if (std::max(at.pads.target[k], at.pads.other[k]) > tip_m - kMargin_m / 2) return i - 1;
  }
  return most;
}

Reason WhatBlocks(const Station& at, int column, float tip_m) {
  const auto c =
      static_cast<std::size_t>(std::clamp(column, 0, static_cast<int>(at.pads.other.size()) - 1));
  if (HandGrid::IsFloorInTheWay(at.pads.other[c])) return Reason::kTooLow;
  constexpr float kOnFloor_m = 0.006F;
  const bool is_floor = at.pads.other[c] < at.FloorAtMiddle() + kOnFloor_m;
  return is_floor && tip_m < at.FloorAtMiddle() + kOnFloor_m ? Reason::kTooLow : Reason::kNeighbor;
}

// Whether the palm stays clear; sets the gap above what is under it.
bool PalmFits(const Station& at, const Run& run, JawPlace& place, Failures& failures) {
  const int half = at.CellsIn(PalmOf(at.gripper).x() / 2);
  const int middle = (run.first + run.last) / 2;
  const float palm_m = place.tip_m + at.gripper.finger_length_m - kMargin_m;
  const float target = Highest(at.palm.target, middle - half, middle + half);
  const float other = Highest(at.palm.other, middle - half, middle + half);
  place.palm_gap_m = std::min(kFarthestTold_m, palm_m - std::max(target, other));
  if (HandGrid::IsFloorInTheWay(other)) {
    failures.Add(Reason::kTooLow);
  } else if (other > palm_m) {
    const bool on_it = Highest(at.pads.other, run.first, run.last) > palm_m;
    failures.Add(on_it ? Reason::kCovered : Reason::kNeighbor);
  }
  return place.palm_gap_m >= 0;
}

// Whether something lies on what would be between the fingers.
bool IsCovered(const Station& at, const Run& run, float tip_m) {
  constexpr float kThick_m = 0.015F;
  int covered = 0;
  for (int c = run.first; c <= run.last; ++c) {
    const auto k = static_cast<std::size_t>(c);
    covered += at.pads.other[k] > std::max(at.pads.target[k], tip_m) + kThick_m ? 1 : 0;
  }
  return covered > 1 && 8 * covered > run.last - run.first + 1;
}

void TryRun(const Station& at, const Run& run, bool is_part, float tip_m, Failures& failures,
            std::vector<JawPlace>& places) {
  const float width = static_cast<float>(run.last - run.first + 1) * at.grid.cell_m;
  if (width > at.gripper.max_opening_m) return failures.Add(Reason::kTooWide);
  if (IsCovered(at, run, tip_m)) {
    const bool is_floor = HandGrid::IsFloorInTheWay(Highest(at.pads.other, run.first, run.last));
    return failures.Add(is_floor ? Reason::kTooLow : Reason::kCovered);
  }
  const float beside =
      (OpenedAround(width, at.gripper) - width) / 2 + at.gripper.finger_thickness_m;
  const int needed = at.CellsIn(beside - at.grid.cell_m / 2);
  const int told = at.CellsIn(kFarthestTold_m), most = needed + told + at.CellsIn(kMostRoom_m);
  const int left = FreeCells(at, run.first, -1, tip_m, most);
  const int right = FreeCells(at, run.last, 1, tip_m, most);
  if (left < needed) return failures.Add(WhatBlocks(at, run.first - left - 1, tip_m));
  if (right < needed) return failures.Add(WhatBlocks(at, run.last + right + 1, tip_m));
  JawPlace place = {at.first_row, at.last_row, run.first, run.last, at.across_m, tip_m, is_part};
  if (!PalmFits(at, run, place, failures)) return;
  const int free = std::min(left, right) - needed;
  place.clearance_m = static_cast<float>(std::min(free, told)) * at.grid.cell_m;
  const float beyond_m = static_cast<float>(std::max(0, free - told)) * at.grid.cell_m;
  place.room_m = std::min(kMostWithCell_m, beyond_m);
  const float below = std::max(std::max(Highest(at.pads.other, run.first - needed, run.first - 1),
                                        Highest(at.pads.other, run.last + 1, run.last + needed)),
                               std::max(Highest(at.pads.target, run.first - needed, run.first - 1),
                                        Highest(at.pads.target, run.last + 1, run.last + needed)));
  place.tip_gap_m = std::min(kFarthestTold_m, tip_m - below);
  place.depth_m = TopOf(at.pads) - tip_m;
  places.push_back(place);
}

void TryHeight(const Station& at, float tip_m, Failures& failures, std::vector<JawPlace>& places) {
  const std::vector<Run> runs = RunsAbove(at, tip_m);
  if (runs.empty()) return;
  TryRun(at, {runs.front().first, runs.back().last}, false, tip_m, failures, places);
  if (runs.size() == 1 || runs.size() > kMostRuns) return;
  for (const Run& run : runs) {
    Failures ignored;  // the whole tells why
    TryRun(at, run, true, tip_m, ignored, places);
  }
}

}  // namespace

float OpenedAround(float width_m, const JawGripper& gripper) {
  constexpr float kBeside_m = 0.01F;
  return std::min(gripper.max_opening_m, width_m + 2 * kBeside_m);
}

void FindJawPlaces(const HandGrid& grid, const TurnedGrid& turned, const JawGripper& gripper,
                   Failures& failures, std::vector<JawPlace>& places) {
  constexpr int kMostStrips = 9;
  constexpr float kBetweenStrips_m = 0.012F;
  const int rows = turned.last_row - turned.first_row + 1;
  if (rows < 1) return;
  const float half_width = gripper.finger_width_m / 2;
  const float length = static_cast<float>(rows) * grid.cell_m;
  // An odd number: one passes through the middle.
  const int strips =
      std::min(kMostStrips, 2 * static_cast<int>(length / (2 * kBetweenStrips_m)) + 1);
  Station at = {grid, turned, gripper, 0, 0, 0, {}, {}};
  for (int i = 0; i < strips; ++i) {
    const float share = (static_cast<float>(i) + 0.5F) / static_cast<float>(strips);
    at.across_m = turned.AcrossOf(turned.first_row) - grid.cell_m / 2 + share * length;
    const auto row = [&](float across) {
      return static_cast<int>(std::lround((across + turned.HalfAcross()) / grid.cell_m - 0.5F));
    };
    at.first_row = std::max(0, row(at.across_m - half_width));
    at.last_row = std::min(turned.num_rows - 1, row(at.across_m + half_width));
    const float half_palm = PalmOf(gripper).y() / 2;
    HighestOf(turned, at.first_row, at.last_row, at.pads);
    HighestOf(turned, row(at.across_m - half_palm), row(at.across_m + half_palm), at.palm);
    const std::vector<float> heights = TipHeights(at);
    if (heights.empty()) failures.Add(WhyNoHeight(at));
    for (const float height : heights) TryHeight(at, height, failures, places);
  }
}

}  // namespace fovea
