// Identities of objects over the frames of one camera.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/tracking/camera_motion.h"
#include "core/tracking/frame_clock.h"
#include "core/tracking/track.h"
#include "core/types/detections.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

// What a frame says beside its images.
struct FrameContext {
  // Of the camera, in a frame of the robot's choice.
  std::optional<Eigen::Isometry3d> camera_pose;
  std::optional<CaptureTime> captured_at;
};

// Tells which object of a frame is which of those before: the camera's motion is taken out
// (camera_motion.h), what is left is decided in space and colour (association.h). Design after
// ByteTrack (Zhang et al. 2022), with boxes in the image, which a moving camera confuses, replaced.
//
// A new object has an id at once, and times_seen = 1 until a second frame confirms it. What is not
// found is kept, hidden, for kKeptHidden_s by the frames' times (frame_clock.h), and named from its
// second frame on: the detector finds some things in one frame of three. What was there in the last
// frame is looked for in the next one however much later that is. What is not in an incomplete
// answer is not said to be gone. Where the camera's motion is not known, boxes are those of the
// frame, nothing is said to move or to be gone, and the means go on when it is known again. It is
// known where most things are where the guess has them.
//
// The same frames give the same tracks, bit for bit. Not thread-safe: one frame after the other.
// Holds at most kMaxTracks tracks of some 7 KB, or 10 in frames whose place is not known; of more
// objects the least confident have none, and of more hidden ones those that were seen last stay.
// With poses or standing some 1 ms, else 15.
class Tracker {
 public:
  static constexpr double kKeptHidden_s = 2;
  static constexpr std::size_t kMaxTracks = 128;

  // `epoch`: what Tracking::epoch says.
  explicit Tracker(std::uint64_t epoch) : epoch_(epoch) {}

  // Fills DetectedObject::track and Detections::tracking. `detections`: of that frame.
  void Add(const RgbdFrame& frame, const FrameContext& context, Detections& detections);

 private:
  // Returns the place, of which the objects may have told what the picture did not.
  CameraPath::Place Match(const std::vector<Sighting>& sightings, CameraPath::Place place,
                          const RgbdFrame& frame, const FrameContext& context,
                          Detections& detections);
  bool MostAreWhereTheyWere(const std::vector<Sighting>& sightings,
                            const std::vector<int>& track_of_sighting) const;
  void Forget();
  // `incomplete`: not all of the frame was looked at.
  std::vector<HiddenTrack> Hidden(const RgbdFrame& frame, std::uint64_t stretch, bool incomplete);

  std::uint64_t epoch_;
  CameraPath path_;
  std::vector<Track> tracks_;  // by id
  std::uint64_t last_id_ = 0;
  FrameClock clock_;
  std::uint64_t last_stretch_ = 0;  // of the last frame
};

}  // namespace fovea
