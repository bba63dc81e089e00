// Points on the true surfaces of solids, in the solid's own frame and metres.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "tests/support/shape.h"

namespace fovea::evaluation {

// About one point for each square of this side, the inside of vessels too; of compounds also what
// is covered by another part. Cost: some four rays per point.
std::vector<Eigen::Vector3d> SampleSurface(const scenes::Shape& shape, double spacing_m);

// Points with the same convex hull as the solid: corners of boxes and 96-gons around circles;
// spheres, and cushions of samples 2 mm apart, to 0.1 %.
std::vector<Eigen::Vector3d> HullPoints(const scenes::Shape& shape);

// The centre of mass, were it of one material: of compounds the mean of the parts' centres by
// volume, of all else the middle (of bowls and cushions within a fifth of their height).
Eigen::Vector3d CenterOfMass(const scenes::Shape& shape);

}  // namespace fovea::evaluation
