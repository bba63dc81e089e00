// What speaks for a grasp and what against it, as numbers.
#pragma once

#include <array>
#include <string_view>

#include "core/grasping/grasp_scene.h"
#include "core/types/detections.h"
#include "core/types/grasp.h"

namespace fovea {

inline constexpr std::size_t kNumGraspTerms = 29;
using GraspTerms = std::array<float, kNumGraspTerms>;

// Lengths in centimetres (kCentimetres of a metre), slopes as tangents, shares 0 … 1. The first
// fifteen are of the object.
inline constexpr float kCentimetres = 100;
enum ObjectGraspTerm : std::size_t {
  kTermDistance,      // from the camera, metres
  kTermConfidence,    // that it is an object
  kTermUnseen,        // share of its surface
  kTermTruncated,     //
  kTermShapeSure,     // confidence of its shape; 0 of kOther without a form
  kTermRound,         // sphere, cylinder, of revolution: 1; oblong, bent: a half
  kTermResidual,      // of the shape
  kTermFlat,          //
  kTermHeight,        // up to 15
  kTermDepthMissing,  //
  kTermSlender,       // its height by its mean width, up to 3
  kTermHiddenBorder,  // share of its outline
  kTermHollow,        //
  kTermSeenThrough,   // share of the outline of its solid
  kTermBesideSolid,   // share of its pixels
  kNumTermsOfObject,
};

enum JawTerm : std::size_t {
  kTermOpeningLeft = kNumTermsOfObject,  // of the gripper beyond what is needed, up to 2
  kTermClearance,                        // beside the fingers, up to 2
  kTermTipGap,                           // below the tips, up to 2
  kTermPalmGap,                          // below the palm, up to 2
  kTermSlopeAcross,                      // the steeper contact, or the line between them
  kTermSlopeDown,                        // the same
  kTermContactWidth,                     // share of the pad's width, the narrower contact
  kTermContactDepth,                     // from the tips up, the lower contact, up to 2.5
  kTermUnseenContacts,                   // share
  kTermHandBehindTarget,                 // share of the fingers
  kTermHandBehindOther,                  // share of the less seen finger; unmeasured counts half
  kTermHandOutside,                      // share of the fingers, outside of the image
  kTermWidth,                            // between the fingers
  kTermRoom,                             // beside each finger as it moves in
};

enum SuctionTerm : std::size_t {
  kTermUnevenness = kNumTermsOfObject,  // of the patch, in standard deviations of depth
  kTermUsable,                          // radius of the patch beyond that of the lip, up to 2
  kTermCurvature,                       // of its most curved direction, of what the lip allows
  kTermTilt,                            // of the approach from the preferred one, sine
  kTermOffCenter,                       // of the axis from the middle, in diameters of the lip
  kTermCovered,                         // share of sixteen sectors of the lip with points
  kTermTubeGap,                         // beside the tube, up to 2
  kTermPoints,                          // under the lip, hundreds of them, up to 2
  kTermDisagrees,                       // sine of the angle between the patch and the shape there
  kTermEvenReach,                       // radius to which the solid is even, in that of the lip
  kTermInside,                          // on the bottom of what is hollow
};

// What a grasp is judged as: a model each.
enum class GraspFamily { kAcross, kRim, kHandle, kSuction };
inline constexpr std::size_t kNumGraspFamilies = 4;

struct ScoredGrasp {
  Grasp grasp;
  GraspFamily family = GraspFamily::kAcross;
  GraspTerms terms{};
};

// What speaks for all grasps of an object; the other terms are 0.
GraspTerms TermsOfObject(const GraspScene& scene, const DetectedObject& object);

}  // namespace fovea
