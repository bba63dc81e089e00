#include "tests/evaluation/tracking/stream_run.h"

#include <algorithm>
#include <ctime>
#include <opencv2/core.hpp>
#include <optional>
#include <utility>

#include "core/detector.h"
#include "core/tracking/tracker.h"
#include "tests/evaluation/tracking/frame_comparison.h"
#include "tests/support/labelled_frame.h"
#include "tests/support/random.h"

namespace fovea::evaluation {
namespace {

// Processor time of this thread: other programs do not count.
double ThreadTime_ms() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

Eigen::Isometry3d Measured(const Eigen::Isometry3d& pose, scenes::Random& random) {
  const auto vector = [&] {
    return Eigen::Vector3d(random.Normal(), random.Normal(), random.Normal());
  };
  const Eigen::Vector3d turn = 0.05 * 3.14159 / 180 / std::sqrt(3) * vector();
  return pose * Eigen::Translation3d(0.001 / std::sqrt(3) * vector()) *
         Eigen::AngleAxisd(turn.norm(), turn.normalized());
}

// The track on the thing in a frame, if any.
std::optional<std::uint64_t> TrackOn(std::uint64_t thing, const TrackFrame& frame) {
  for (std::size_t i = 0; i < frame.things.size(); ++i) {
    if (frame.things[i] != thing || frame.tracks.empty()) continue;
    Eigen::Index best = 0;
    const double similarity = frame.similarity.row(static_cast<Eigen::Index>(i)).maxCoeff(&best);
    if (similarity >= 0.5) return frame.tracks[best];
  }
  return std::nullopt;
}

}  // namespace

void JudgeCovered(std::uint64_t thing, TrackedStream& stream) {
  std::optional<std::uint64_t> before, after;
  bool is_away = false;
  for (const TrackFrame& frame : stream.frames) {
    const bool is_seen = std::count(frame.things.begin(), frame.things.end(), thing) > 0;
    if (!is_seen && before) is_away = true;
    const auto track = TrackOn(thing, frame);
    if (track && !is_away) before = track;
    if (track && is_away && !after) after = track;
  }
  stream.was_covered = is_away;
  stream.is_found_after = is_away && after;
  stream.is_same_after = stream.is_found_after && *before == *after;
}

std::array<TrackedStream, 2> TrackStream(const StreamSpec& spec, const DetectorOptions& options,
                                         Masks masks) {
  const SceneStream stream = RandomStream(spec.motion, spec.kind, spec.seed);
  scenes::Random random(spec.seed);
  std::array<Tracker, 2> trackers = {Tracker(1), Tracker(1)};
  std::array<TrackedStream, 2> results;
  for (std::size_t i = 0; i < stream.frames.size(); ++i) {
    const scenes::Scene& scene = stream.frames[i];
    const scenes::LabelledFrame truth = MakeFrame(scene, spec.sensor, spec.seed * 1000 + i);
    const Detections detections =
        masks == Masks::kTrue ? TrueDetections(truth) : Detect(truth.frame, options);
    const std::int32_t tenths = static_cast<std::int32_t>(i % 10);
    FrameContext context;
    context.captured_at =
        CaptureTime{1'000'000 + static_cast<std::int64_t>(i / 10), tenths * 100'000'000};
    context.camera_pose = Measured(scene.camera.world_from_camera, random);
    for (const Poses poses : {Poses::kGiven, Poses::kNone}) {
      const auto k = static_cast<std::size_t>(poses);
      if (poses == Poses::kNone) context.camera_pose.reset();
      Detections found = detections;
      const double began_ms = ThreadTime_ms();
      trackers[k].Add(truth.frame, context, found);
      results[k].times_ms.push_back(ThreadTime_ms() - began_ms);
      ++results[k].motion_sources[found.tracking->motion.source];
      results[k].frames.push_back(Compare(truth, found));
    }
  }
  for (TrackedStream& result : results) {
    if (stream.covered != 0) {
      JudgeCovered(static_cast<std::uint64_t>(stream.covered), result);
    }
  }
  return results;
}

}  // namespace fovea::evaluation
