// How sure a fitted solid is.
#pragma once

#include "core/shape/solid_fit.h"
#include "core/types/box_uncertainty.h"

namespace fovea {

// Of the box around a solid, in its level frame: the middle, the turn about the upright, and the
// sizes along `along`, across it and upwards.
//
// The inverse of the robust cost's second derivatives, which say how far each number may move
// before the points and the outline speak against it; what they say nothing of (a hidden back side)
// is bounded by the size of the solid. Points of a depth image do not err independently, and a
// solid is not quite what an object is: all is stretched by factors that were fitted to generated
// scenes, so that some 68 of a hundred errors are within one standard deviation (`fovea-eval
// objects`). Finite however thin the solid is. `cost`: as FittedSolid has it. Cost: some hundredths
// of a ms.
BoxUncertainty UncertaintyOf(const SeenObject& seen, const Solid& fitted, float cost);

}  // namespace fovea
