// The solid of a kind that explains best what was seen of an object.
#pragma once

#include <Eigen/Core>

#include "core/shape/solid.h"
#include "core/shape/solid_residuals.h"

namespace fovea {

struct FittedSolid {
  Solid solid;
  float cost = 1;  // 0 … 1: mean over points and rays of r² / (1 + r²), r in standard deviations
  float residual_m = 0;    // root mean square distance of the points that it explains
  float hollow_share = 0;  // of the points: below the rim, of which enough is seen, of a frustum or
                           // an upright cylinder
};

// Starts from a solid that is roughly right. Minimises the mean of the robust costs (Geman and
// McClure 1985) of distances between points and surface, and between surface and the rays that
// touch it, from wide to narrow, by Levenberg-Marquardt. Takes some 0.1 ms for 160 points and 80
// rays, half of it the narrow steps; the cost before them says already whether they are worth it.
class SolidFitting {
 public:
  // Takes the wide steps. Refers to `seen`, which must outlive it. Throws std::length_error for
  // more than kMaxSeen points and rays.
  SolidFitting(const SeenObject& seen, const Solid& start);

  float Cost() const;  // as FittedSolid::cost is without what hollows add to it
  void Finish();       // takes the narrow ones
  FittedSolid Result();

 private:
  void Descend(float scale, int num_steps);

  const SeenObject& seen_;
  Solid start_, solid_;
  SolidResiduals residuals_;
  SeenArray at_;  // the residuals of the solid
  float damping_ = 1e-2F;
};

}  // namespace fovea
