// How a hand takes an object. Camera frame, metres.
#pragma once

#include <Eigen/Core>
#include <string>

namespace fovea {

constexpr float kLeastPreGrasp_m = 0.1F;    // from the grasp to where the hand moves in from,
constexpr float kPreGraspBeyond_m = 0.02F;  // and so far beyond what it reaches into
constexpr float kLeastWay_m = 0.15F;        // of the way in, what a hand needs free at least

struct Grasp {
  enum class Kind {
    kAcross,   // the fingers on both sides of the whole object
    kRim,      // one finger inside, one outside of a wall
    kHandle,   // across a part of it that is thinner than the rest
    kSide,     // across, moving in rather level than downwards
    kSuction,  // a cup on a flat or slightly curved patch
  };
  Kind kind = Kind::kAcross;
  std::size_t gripper = 0;  // index into the grippers that were asked for
  // Midway between the finger tips; of suction, the middle of the lip on the surface.
  Eigen::Vector3f tool_center_point = Eigen::Vector3f::Zero();
  Eigen::Vector3f approach = Eigen::Vector3f::UnitZ();  // unit: the way the hand moves in
  Eigen::Vector3f closing = Eigen::Vector3f::UnitX();   // unit: the way the fingers close; of
                                                        // suction, any direction along the surface
  // Distance between the fingers that the object needs, without clearance; 0 for suction.
  float opening_m = 0;
  // Before and while the hand moves in: 10 mm more on each side, and up to 35 mm where 20 mm more
  // than that are free, since a side that is not seen may lie farther out; at most what the hand
  // can. 0 for suction.
  float pre_grasp_opening_m = 0;
  // From the pre-grasp, where the hand is clear of everything, to the tool centre point: the
  // pre-grasp is tool_center_point - approach * pre_grasp_distance_m. At least 0.1 m, and 2 cm more
  // than the finger tips are below the object's top or a cup below the rim of what is hollow.
  float pre_grasp_distance_m = kLeastPreGrasp_m;
  // Smallest distance of the open hand, on its way in, to what else was seen or may be there; up to
  // 0.02. Of jaws it is known of grasps that are offered alone.
  float clearance_m = 0;
  // Share of both contact areas, or of the lip of a cup, that no pixel shows, 0 … 1.
  float unseen_contacts = 0;
  // How much of a cross section of what the palm or the tube passes on the last 0.15 m and more of
  // its way in the camera did not see to be free, where that is most, 0 … 1. Known of grasps that
  // are offered alone.
  float unseen_way = 0;
  float probability = 0;  // of success, 0 … 1, calibrated on generated scenes
  // Of suction: root mean square distance of the patch from the surface fitted to it, the largest
  // cup that fits on (1, 1.25, 1.5, 2 or 3 times its width), and the object's middle from the axis.
  float unevenness_m = 0;
  float usable_diameter_m = 0;
  float off_center_m = 0;
};

// Why a gripper has no grasp of an object: what the most candidates failed for.
struct NoGrasp {
  enum class Reason {
    kTooWide,   // for the opening, wherever it could be taken
    kNeighbor,  // something else is in the way
    kCovered,   // something lies on it, or hides the way in
    kTooLow,    // the hand would touch what it stands on
    kSloped,    // its sides would slip out of the fingers; suction: no face is within reach
    kCut,       // it is truncated where it would be taken
    kTooLittleSeen,
    kNoSeal,    // suction: no patch is flat and wide enough
    kUnlikely,  // there are candidates, and none is likely to succeed; or fingers are too short
  };
  std::size_t gripper = 0;
  Reason reason = Reason::kTooLittleSeen;
};

}  // namespace fovea
