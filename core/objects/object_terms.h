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
  kSlenderness,    // of the smaller level extent to the larger one
  kSolidity,       // of the area to that of the extents
  kDistance,       // metres
  kCovered,        // share that lies under a support: legs, floors under tables
  kFlat,           // share of the voxels that no height tells from a support
  kFacingUp,       // share of the voxels
  kClosed,         // share of the upper border behind or beyond which it may go on
  kGoesOn,         // 1 where that is much
  kEnd,            // share that ends with the image
  kEndsAnywhere,   // 1 where that is any
  kUnmeasured,     // share beyond which nothing is measured,
  kFarther,        // something is farther away,
  kNearer,         // background is in front,
  kNearerSegment,  // a segment is in front,
  kRising,         // beside or above which background goes on upwards,
  kLevel,          // or is level,
  kLevelSegment,   // a segment is at the same distance
  kStands,         // share of the lower border below which background is level: a support
  kAlone,          // 1 for a single segment
  kNumSegments,    // logarithm
  kInnerOdds,      // log odds of the join that made it,
  kOuterOdds,      // and of the one that it is part of
  kLikely,         // 1 where the former are for and the latter against it
  kContrast,       // logarithm of the difference of colour to background at its distance, CIELAB
  kLevelShare,     // share beyond which there is such background
  kNearestJoin,    // the first of TermsOf the kinship with what it is joined to next
};
constexpr std::size_t kNumObjectTerms =
    static_cast<std::size_t>(ObjectTerm::kNearestJoin) + kNumKinshipTerms;
using ObjectTerms = std::array<double, kNumObjectTerms>;

ObjectTerms TermsOf(const ObjectEvidence& evidence);

// Of each term, for people who ask why something is no object.
std::string_view NameOf(ObjectTerm term);

}  // namespace fovea
