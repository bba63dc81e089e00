// The solid of a kind that explains best what was seen of an object.
#pragma once

#include <vector>

#include "core/shape/seen_object.h"
#include "core/shape/solid.h"

namespace fovea {

struct FittedSolid {
  Solid solid;
  float cost = 1;  // 0 … 1: mean over points and rays of r² / (1 + r²), r in standard deviations
  float residual_m = 0;    // root mean square distance of the points that it explains
  float hollow_share = 0;  // of the points that are seen through the top of a frustum or an upright
                           // cylinder: below its rim; 0 where too little is seen of that
};

// Starts from solids that are roughly right, each of another kind. Minimises the mean of the robust
// costs (Geman and McClure 1985) of distances between points and surface, and between surface and
// the rays that touch it, from wide to narrow, by Levenberg-Marquardt. Those that explain much less
// than the best after the first steps are left as they are then.
std::vector<FittedSolid> FitSolids(const SeenObject& seen, const std::vector<Solid>& starts);

}  // namespace fovea
