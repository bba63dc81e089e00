// The measured points around an object in the columns of a hand's grid.
#pragma once

#include <Eigen/Core>

#include "core/grasping/grasp_scene.h"
#include "core/grasping/hand_grid.h"
#include "core/grasping/solid_line.h"
#include "core/types/detections.h"

namespace fovea {

// `solid`: the object's, in the grid's frame: of its points only those well outside of it count,
// all where it is not known. `half_extents`: of its box along the axes of the grid. Points on the
// plane that it stands on, and unlabelled ones at the edge of its mask, which may be of it, are
// left out.
void AddPoints(const GraspScene& scene, const DetectedObject& object, const CompletedSolid& solid,
               const Eigen::Vector3f& half_extents, HandGrid& grid);

}  // namespace fovea
