// Points that are spread over the surface of a solid.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/shape/solid.h"

namespace fovea {

struct SurfaceSample {
  Eigen::Vector3f position;  // level frame of the solid
  Eigen::Vector3f normal;    // unit vector, outwards
  float area_m2 = 0;         // that it stands for
};

// Some 200, without the bottom that the solid stands on.
std::vector<SurfaceSample> SampleSurface(const Solid& solid);

}  // namespace fovea
