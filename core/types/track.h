// What is known of objects beyond one frame. All positions are in the camera frame of the frame
// that is answered (optical: x right, y down, z forward) in metres.
#pragma once

#include <Eigen/Geometry>
#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/types/oriented_box.h"

namespace fovea {

// When a frame was taken, by whatever clock its camera has.
struct CaptureTime {
  std::int64_t seconds = 0;
  std::int32_t nanos = 0;  // 0 … 999,999,999

  // NOLINTNEXTLINE(modernize-use-nullptr): of the 0 that comparisons are made with
  friend auto operator<=>(const CaptureTime&, const CaptureTime&) = default;
};

// An object that was seen in several frames.
struct ObjectTrack {
  std::uint64_t id = 0;  // 1, 2, … in the order of appearance
  // Of the first frame that showed it; none where that frame had no time.
  std::optional<CaptureTime> first_seen;
  std::uint32_t times_seen = 0;     // in answers, this one included; 1: it may be a mistake
  OrientedBox steadied_box;         // mean over the last answers (core/tracking/steadied_box.h)
  std::uint32_t steadied_over = 0;  // so many of them
  bool is_moving = false;           // against the background
};

// Where the camera's motion since the frame before comes from.
enum class CameraMotionSource {
  kFirstFrame,  // there is no frame before
  kGiven,       // by the poses of both frames
  kEstimated,   // from the frames
  kStanding,    // the frames show that it has not moved
  kUnknown,     // neither; guessed
};

struct CameraMotion {
  CameraMotionSource source = CameraMotionSource::kFirstFrame;
  Eigen::Isometry3d last_from_this = Eigen::Isometry3d::Identity();  // points of this camera frame
};

// Why an object that was seen before is not among those of this frame.
enum class HiddenReason {
  kCovered,      // something nearer is before it
  kOutOfView,    // the camera looks elsewhere
  kNotDetected,  // its surface seems to be there, or nothing was measured
  kGone,         // the camera sees through where it was
};

struct HiddenTrack {
  std::uint64_t id = 0;
  OrientedBox box;  // the last, where it should be now
  std::optional<CaptureTime> last_seen;
  std::uint32_t times_seen = 0;
  HiddenReason reason = HiddenReason::kNotDetected;
};

// Of one frame in a sequence.
struct Tracking {
  std::uint64_t epoch = 0;  // ids are unique within it; not 0
  CameraMotion motion;
  std::vector<HiddenTrack> hidden;  // by id
};

}  // namespace fovea
