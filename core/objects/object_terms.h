// What of the evidence for an object counts, as numbers.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "core/objects/object_evidence.h"
#include "core/segmentation/kinship.h"

namespace fovea {

// Lengths and areas are natural logarithms of metres and square metres; shares are of the border of
// the segment, 0 … 1.
enum class ObjectTerm {
  kArea,           // as seen from the camera
  kLargestExtent,  // to the right, away or up
  kHeight,
  kSlenderness,   // of the smaller level extent to the larger one
  kSolidity,      // of the area to that of the extents
  kDistance,      // metres
  kFlat,          // share of the voxels that no height tells from a support
  kFacingUp,      // share of the voxels
  kClosed,        // share of the upper border behind or beyond which it may go on
  kEndsAnywhere,  // 1 where any of it ends with the image
  kUnmeasured,    // share beyond which nothing is measured,
  kFarther,       // something is farther away,
  kLevelSegment,  // a segment is at the same distance
  kNumSegments,   // logarithm
  kOuterOdds,     // log odds of the join that it is part of
  kContrast,      // logarithm of the difference of colour to background at its distance, CIELAB
  kNearestJoin,   // the first of TermsOf the kinship with what it is joined to next
};
constexpr std::size_t kNumObjectTerms =
    static_cast<std::size_t>(ObjectTerm::kNearestJoin) + kNumKinshipTerms;
using ObjectTerms = std::array<double, kNumObjectTerms>;

ObjectTerms TermsOf(const ObjectEvidence& evidence);

// Of each term, for people who ask why something is no object.
std::string_view NameOf(ObjectTerm term);

}  // namespace fovea
