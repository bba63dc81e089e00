// Tracks the objects of generated streams.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/options.h"
#include "core/types/track.h"
#include "tests/evaluation/tracking/streams.h"
#include "tests/evaluation/tracking/track_scores.h"
#include "tests/support/sensor.h"

namespace fovea::evaluation {

// How the tracker learns of the camera's motion.
enum class Poses { kGiven, kNone };

struct TrackedStream {
  TrackSequence frames;
  std::vector<double> times_ms;                      // processor time of tracking a frame
  std::map<CameraMotionSource, int> motion_sources;  // frames with each
  // Of the thing that is covered: whether it was found before that, then after it too, and then
  // under one id.
  bool was_covered = false, is_found_after = false, is_same_after = false;
};

// Sets these of `thing`.
void JudgeCovered(std::uint64_t thing, TrackedStream& stream);

struct StreamSpec {
  std::string motion, kind;
  std::uint64_t seed = 0;
  scenes::SensorKind sensor = scenes::SensorKind::kKinect;
};

// What is detected, once for both ways to track.
enum class Masks { kDetected, kTrue };

// With poses, which are off by 1 mm and 0.05° as an arm's are, and without; as `Poses` numbers
// them.
std::array<TrackedStream, 2> TrackStream(const StreamSpec& spec, const DetectorOptions& options,
                                         Masks masks);

}  // namespace fovea::evaluation
