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
  float along_m = 0;           // where the finger stops, along the closing direction
  float slope_across = 0;      // of the surface there against the pad, as a tangent: across the pad
  float slope_down = 0;        // and along it
  float share = 0;             // of the pad's width that touches
  bool is_exact = false;       // of a solid that is known, not of columns
  Span across_m, above_tip_m;  // where it touches: across the pads, and from the tip up
  std::vector<Eigen::Vector3f> places;  // that touch, in the grid's frame
};

// How far from the closing direction the straightest line from one contact to the other runs, as
// tangents: across the pads and along them. Thin things are held well only where both fingers touch
// at the same place. `width_m`: between them, above 0.
Eigen::Vector2f LineBetween(const std::array<JawContact, 2>& contacts, float width_m);

// How far out the object reaches before one place of a pad, along the way towards the finger.
struct PadReach {
  float across_m, height_m, outwards_m;
};

// Closes a jaw on places of one turn of the hand. From the completed solid where it is known and
// the place is around the whole object, else from the columns of the grid. What it is made from
// must outlive it.
class JawCloser {
 public:
  JawCloser(const TurnedGrid& turned, const CompletedSolid& solid, const JawGripper& gripper);

  // Of the fingers that close towards +closing and -closing; until it is asked for the next.
  const std::array<JawContact, 2>& CloseOn(const JawPlace& place);

 private:
  using Reaches = std::vector<PadReach>;  // of one pad

  void ReachThroughSolid(const JawPlace& place);
  void ReachThroughColumns(const JawPlace& place);
  bool AgreeWithColumns() const;
  void SetContact(const Reaches& reaches, const JawPlace& place, float sign, float patch_m,
                  bool is_exact, JawContact& contact);

  const TurnedGrid& turned_;
  const CompletedSolid& solid_;
  const JawGripper& gripper_;
  std::array<JawContact, 2> contacts_;
  // Kept for the next place.
  std::array<Reaches, 2> of_columns_, of_solid_;
  Reaches pad_, near_;
  Lines lines_;
  std::vector<Span> spans_;
};

}  // namespace fovea
