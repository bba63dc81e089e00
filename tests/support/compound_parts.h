// Parts of compounds, placed in the frame of the whole, and bodies made of them.
#pragma once

#include <vector>

#include "tests/support/random.h"
#include "tests/support/scene.h"
#include "tests/support/shape.h"

namespace fovea::scenes {

// `material` is Part::material throughout.
Part BlockPart(const Eigen::Vector3d& center, const Eigen::Vector3d& size_m, int material = 0);
Part BallPart(const Eigen::Vector3d& center, double diameter_m, int material = 0);

// A solid cylinder around the line between two points.
Part RodPart(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double diameter_m,
             int material = 0);

// An upright solid cylinder around the z axis, from one height to another.
Part DiskPart(double low_m, double high_m, double diameter_m, int material = 0);

// A cup around the z axis that stands on z = 0.
Part VesselPart(double diameter_m, double height_m, double wall_m);

// Rods from each point to the next, their joints rounded.
void AddBentRod(std::vector<Part>& parts, const std::vector<Eigen::Vector3d>& points,
                double diameter_m, int material = 0);

// `part` turned about its own centre by `angle_rad` about an axis of the whole.
Part Turned(Part part, double angle_rad, const Eigen::Vector3d& axis);

Body Compound(const char* name, std::vector<Part> parts);

// Lays a body down in a share of all cases: turned about its y axis, so that its x axis is
// vertical.
Body SometimesLying(Body body, double share, Random& random);

}  // namespace fovea::scenes
