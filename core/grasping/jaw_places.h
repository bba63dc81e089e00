// Where an open hand can stand around an object, or a part of it, without touching anything.
#pragma once

#include <vector>

#include "core/grasping/failures.h"
#include "core/grasping/turned_grid.h"
#include "core/types/gripper.h"

namespace fovea {

// Of a turned grid: the columns that the fingers close on, and how far its tips reach.
struct JawPlace {
  int first_row = 0, last_row = 0;        // across the pads
  int first_column = 0, last_column = 0;  // of what is between the fingers
  float across_m = 0;                     // the middle of the pads
  float tip_m = 0;                        // height of the finger tips
  bool is_part = false;   // only one of several parts of the object between which fingers fit
  float clearance_m = 0;  // beside the open fingers, up to 20 mm
  float room_m = 0;       // beyond that clearance, to open wider on each side, up to 25 mm
  float tip_gap_m = 0;    // below the tips, up to 20 mm
  float palm_gap_m = 0;   // above what is under the palm, up to 20 mm
  float depth_m = 0;      // of the tips below the object's top
};

// How wide the hand opens around something: 10 mm more on each side where it can.
float OpenedAround(float width_m, const JawGripper& gripper);

// Appends the places of one turn of the hand: up to nine strips across the object, five depths,
// five parts each. What does not work is counted in `failures`.
void FindJawPlaces(const HandGrid& grid, const TurnedGrid& turned, const JawGripper& gripper,
                   Failures& failures, std::vector<JawPlace>& places);

}  // namespace fovea
