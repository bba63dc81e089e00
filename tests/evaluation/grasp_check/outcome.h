// How a grasp ends in a scene whose solids are known.
#pragma once

#include <array>

namespace fovea::evaluation {

enum class Outcome {
  kSuccess,
  kTooWide,            // needs more than the gripper opens
  kHitsTarget,         // on the way in, by the open hand
  kHitsNeighbor,       // the same
  kHitsFurniture,      // what objects stand on, walls
  kOtherBodyFirst,     // a closing finger meets something else before the target, or the cup does
  kNoContact,          // of a finger with the target
  kSlips,              // contacts beyond friction, or not opposed
  kNoSeal,             // of suction: edge, too uneven or too curved under the lip
  kTilted,             // of suction: the surface does not face the cup
  kTooFarFromTheMass,  // of suction: the object would twist off
};

inline constexpr std::array<const char*, 11> kOutcomeNames = {
    "success",    "too wide", "hits target", "hits neighbour", "hits furniture", "other body first",
    "no contact", "slips",    "no seal",     "tilted",         "off the mass"};

constexpr const char* NameOf(Outcome outcome) {
  return kOutcomeNames[static_cast<std::size_t>(outcome)];
}

}  // namespace fovea::evaluation
