// Which tracks an answer has.
#pragma once

#include <cstdint>
#include <vector>

#include "core/types/detections.h"

namespace fovea::testing {

inline std::vector<std::uint64_t> Ids(const Detections& detections) {
  std::vector<std::uint64_t> ids;
  for (const DetectedObject& object : detections.objects) ids.push_back(object.track->id);
  return ids;
}

inline std::vector<std::uint64_t> HiddenIds(const Detections& detections) {
  std::vector<std::uint64_t> ids;
  for (const HiddenTrack& track : detections.tracking->hidden) ids.push_back(track.id);
  return ids;
}

}  // namespace fovea::testing
