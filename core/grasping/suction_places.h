// Where on an object a suction cup may lie.
#pragma once

#include <Eigen/Core>
#include <opencv2/core/types.hpp>
#include <vector>

#include "core/grasping/grasp_scene.h"
#include "core/grasping/solid_line.h"
#include "core/grasping/suction_patch.h"
#include "core/types/detections.h"
#include "core/types/gripper.h"

namespace fovea {

// Camera frame.
struct SuctionPlace {
  cv::Point pixel;         // in which it is, or would be, seen
  Eigen::Vector3f center;  // on the surface
  Eigen::Vector3f normal;  // unit vector, out of it
  float curvature_per_m = 0;
  SuctionPatch seen;       // of it; without points where too little is
  bool of_solid = false;   // where the completed solid is best to lie on, not around a seen point
  bool is_inside = false;  // on the bottom of what is hollow
};

// Around pixels that are spread over the mask, at most 64, as far as enough points are around them.
// `num_missed` counts the others.
std::vector<SuctionPlace> SeenPlaces(const GraspScene& scene, const DetectedObject& object,
                                     float diameter_m, int& num_missed);

// The middle of each face of a box and of the ends of a cylinder, the line on its side and the
// point of a ball that face `approach` most, the bottom of bowls and cups: also where few points of
// them are seen, or none. Nothing for other things, and nothing where the camera sees past them.
std::vector<SuctionPlace> SolidPlaces(const GraspScene& scene, const DetectedObject& object,
                                      const Eigen::Vector3f& approach, float diameter_m);

// Whether a lip of this radius around the place would lie on the completed solid, which is known,
// as evenly as the cup asks, however the solid is curved. `frame`: that of the solid. What is
// hollow counts as filled but for places inside.
bool IsOnSolid(const DetectedObject& object, const CompletedSolid& solid, const LevelFrame& frame,
               const SuctionPlace& place, const SuctionGripper& cup, float radius_m);

// The radius up to which a lip around the place would lie on the completed solid as evenly as the
// cup asks, in radii of the cup, up to 2; 0 if not even a small one. 1 where the solid is not
// known. `frame`: that of the solid.
float EvenReach(const DetectedObject& object, const CompletedSolid& solid, const LevelFrame& frame,
                const SuctionPlace& place, const SuctionGripper& cup);

}  // namespace fovea
