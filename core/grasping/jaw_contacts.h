// Where closing fingers meet the object, and how steep it is there.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/grasping/jaw_places.h"
#include "core/grasping/solid_line.h"
#include "core/grasping/turned_grid.h"
#include "core/types/gripper.h"

namespace fovea {

struct JawContact {
  float along_m = 0;       // where the finger stops, along the closing direction
  float slope_across = 0;  // of the surface there against the pad, as a tangent: across the pad
  float slope_down = 0;    // and along it
  float share = 0;         // of the pad's width that touches
  float depth_m = 0;       // from the tip up to where it touches still
  std::vector<Eigen::Vector3f> places;  // that touch, in the grid's frame
};

// Of the fingers that close towards +closing and -closing. From the completed solid where it is
// known and the place is around the whole object, else from the columns of the grid.
std::array<JawContact, 2> CloseOn(const TurnedGrid& turned, const CompletedSolid& solid,
                                  const JawPlace& place, const JawGripper& gripper);

}  // namespace fovea
