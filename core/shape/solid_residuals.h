// How far a solid is from explaining what was seen of an object.
#pragma once

#include <Eigen/Core>

#include "core/shape/solid.h"
#include "core/shape/solid_fit.h"

namespace fovea {

// What is not seen of a box is likely not much thinner than what is, and oblongs are hardly longer
// than wide: 0 if so. Moves sides by tenths of a millimetre where they are seen, and decides where
// nothing else does.
float Unlikeliness(const Solid& solid);

// 1 for the points whose lines of sight pass the top of an upright round solid, well inside of its
// rim. None where the camera is not above it.
SeenArray IsThroughTop(const SeenObject& seen, const Solid& solid);

// 1 for those of them that are below the top: of a hollow.
SeenArray IsBelowRim(const SeenObject& seen, const Solid& solid);

// Distances, in standard deviations, of the points and of the rays, and where each ray is nearest.
class SolidResiduals {
 public:
  // Refers to `seen`, which must outlive it and its copies. Throws std::length_error for more than
  // kMaxSeen points and rays.
  explicit SolidResiduals(const SeenObject& seen);

  // With the places along the rays that are nearest to this solid.
  const SeenArray& Of(const Solid& solid);

  // With those of the last call of Of().
  const SeenArray& AtNearest(const Solid& solid);

 private:
  void FindNearest(const Solid& solid);
  template <typename Distance>
  void Narrow(const Distance& distance, const SeenArray& reach, int num_sections);
  void MarkHollow(const Solid& solid);

  const SeenObject* seen_;
  LevelPoints on_rays_;
  SeenArray places_;  // along the rays, of what is nearest to the solid
  bool has_hollow_ = false;
  SeenArray is_hollow_;  // of points, where there are any
  SeenArray distances_, all_;
};

// The robust cost of the residuals around a solid, to second order in its parameters (as Moved
// takes them), for residuals of which those above `scale` standard deviations count less and less.
struct NormalEquations {
  ParameterMatrix normal;
  ParameterVector gradient;
};

// `at`: the residuals of the solid.
NormalEquations Linearize(SolidResiduals& residuals, const Solid& solid, const SeenArray& at,
                          float scale);

// As if a solid that is unlikely were `weight` residuals more.
void AddUnlikeliness(const Solid& solid, float weight, NormalEquations& equations);

}  // namespace fovea
