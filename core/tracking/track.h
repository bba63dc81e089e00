// One thing over time. All positions are in the camera frame of the last frame that was tracked.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>

#include "core/tracking/sighting.h"
#include "core/tracking/steadied_box.h"
#include "core/tracking/velocity_filter.h"
#include "core/types/track.h"

namespace fovea {

constexpr float kFastest_m_s = 1;  // that a hand moves things

class Track {
 public:
  Track(std::uint64_t id, const Sighting& first, const std::optional<CaptureTime>& at);

  // The camera has moved, and so many seconds have passed.
  void Advance(const Eigen::Isometry3f& this_from_last, double seconds);
  // It was seen, or not, in the frame that was advanced to. `camera_error_m`: what is not known of
  // the camera's motion since the frame before.
  void OnSeen(const Sighting& sighting, double camera_error_m,
              const std::optional<CaptureTime>& at);
  void OnMissed() { was_seen_ = false; }

  std::uint64_t id() const { return id_; }
  std::uint32_t times_seen() const { return times_seen_; }
  bool was_seen() const { return was_seen_; }  // in the last frame
  double seconds_hidden() const { return seconds_hidden_; }
  const std::optional<CaptureTime>& last_seen() const { return last_seen_; }
  // As it was seen last, where it should be now.
  const Sighting& expected() const { return expected_; }

  ObjectTrack ToObjectTrack() const;

 private:
  void FollowMotion(const Sighting& sighting, double camera_error_m);
  void StandStill(const Sighting& sighting);

  std::uint64_t id_;
  std::optional<CaptureTime> first_seen_, last_seen_;
  std::uint32_t times_seen_ = 1;
  bool was_seen_ = true;
  double seconds_hidden_ = 0;  // since it was seen last
  Sighting expected_;
  SteadiedBox steadied_;
  Eigen::Vector3f steady_centroid_;
  // Of what is off its steady place, that in the last frame; none where it was at it.
  std::optional<Eigen::Vector3f> off_;
  double off_seconds_ = 0;                // since then
  std::optional<VelocityFilter> filter_;  // of what moves against the background
  int slow_ = 0;                          // frames in turn
};

}  // namespace fovea
