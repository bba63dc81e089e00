// The inside of bowls and cups.
#pragma once

#include "core/grasping/hand_grid.h"
#include "core/types/detections.h"

namespace fovea {

// Lowers the object's columns to what is seen through its top, turned about its axis: whatever the
// camera saw past on its way to a point inside is empty, and so it is all around. For hands that
// move in along the axis, within 25°; else nothing changes.
void HollowOut(const DetectedObject& object, HandGrid& grid);

}  // namespace fovea
