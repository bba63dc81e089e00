// How likely two segments that touch are parts of one object.
#pragma once

#include <array>
#include <string_view>

#include "core/segmentation/boundary.h"
#include "core/segmentation/part.h"

namespace fovea {

// What speaks for or against it.
struct Kinship {
  // How far the boundary is from one even surface, 0 … 1: edges, grooves and steps.
  double unevenness = 0;
  // 1 for one mean colour, towards 0 the farther the colours are apart.
  double color_likeness = 0;
  // Between the upper ends, as a share of the height of both: parts of boxes and cans share theirs.
  double top_step = 0;
  double height_m = 0;    // of both together,
  double log_area = 0;    // natural logarithm of the area of both in m²,
  double distance_m = 0;  // and their mean distance from the camera, along z, at most 3 m
  // 1 where one of them has no height, towards 0 the higher the lower of both is: tops and lids are
  // parts, hardly anything that flat is an object beside another.
  double flatness = 0;
  // Mean angle along the boundary, positive for an edge and negative for a groove, times
  // (1 − flatness): what is flat touches everything in a groove.
  double convexity_deg = 0;
  // 1 where the colour goes on across the boundary, towards 0 the more it changes there.
  double color_continuity = 0;
  // How long the boundary is against the smaller one: logarithm of pairs of voxels over the root of
  // its voxels.
  double contact = 0;
  double log_area_ratio = 0;    // of the smaller to the larger one, 0 for two of a size,
  double log_smaller_area = 0;  // and of the smaller one in m²
  // Between the ends to the left or those to the right, whichever are closer, as a share of the
  // width of both: faces of one object share a side, and its parts more often than two objects.
  double side_step = 0;
  double depth_overlap = 0;   // what both have in common of their extent away from the camera,
  double height_overlap = 0;  // and of their height, 0 … 1
  double rise = 0;            // how much the way across the boundary goes up, 0 … 1
};

Kinship KinshipOf(const Boundary& boundary, const Part& a, const Part& b);

// The logarithm of the odds, positive where one object is more likely than two: a linear function
// of what speaks for and against it and of some products, for what one thing says depends on
// another. Weights by logistic regression on segments of scenes whose objects are known
// (`fovea-eval kinship`; docs/fitted_models.md says which scenes).
double LogOdds(const Kinship& kinship);

// The terms of that function by number and name, for those who fit the weights.
constexpr std::size_t kNumKinshipTerms = 16;
using KinshipTerms = std::array<double, kNumKinshipTerms>;
KinshipTerms TermsOf(const Kinship& kinship);
const std::array<std::string_view, kNumKinshipTerms>& KinshipTermNames();

}  // namespace fovea
