// One thing over time. All positions are in the camera frame of the last frame that was tracked.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>

#include "core/tracking/sighting.h"
#include "core/tracking/spot.h"
#include "core/tracking/steadied_box.h"
#include "core/tracking/velocity_filter.h"
#include "core/types/track.h"

namespace fovea {

constexpr float kFastest_m_s = 1;  // that a hand moves things

class Track {
 public:
  // `stretch`: of the frame, as CameraPath::Place has it, here and below.
  Track(std::uint64_t id, const Sighting& first, const std::optional<CaptureTime>& at,
        std::uint64_t stretch = 0);

  // The camera has moved, and so many seconds have passed. `adding_up_m`: what is not known of the
  // motion, where that adds up from frame to frame.
  void Advance(const Eigen::Isometry3f& this_from_last, double seconds, double adding_up_m = 0);
  // The frame that was advanced to is of this stretch: the track is where its last frame had it.
  void Enter(std::uint64_t stretch);
  // It was seen, or not, in the frame that was advanced to. `camera_error_m`: what is not known of
  // the camera's motion since the frame before. In a stretch that is not the mean's it tells
  // nothing of where the thing is beside that; with a second frame of that stretch the mean starts
  // anew.
  void OnSeen(const Sighting& sighting, double camera_error_m, const std::optional<CaptureTime>& at,
              std::uint64_t stretch = 0);
  void OnMissed() { was_seen_ = false; }
  // The camera saw that it is not where it was.
  void OnGone() { was_gone_ = true; }

  std::uint64_t id() const { return id_; }
  std::uint32_t times_seen() const { return times_seen_; }
  bool was_seen() const { return was_seen_; }  // in the last frame
  bool was_gone() const { return was_gone_; }  // since it was seen last
  double seconds_hidden() const { return seconds_hidden_; }
  const std::optional<CaptureTime>& last_seen() const { return last_seen_; }
  // It was seen in a frame whose place is known beside those of this stretch.
  bool IsOf(std::uint64_t stretch) const { return seen_in_ == stretch; }
  // That holds for all frames that its mean is of.
  bool HasMeanOf(std::uint64_t stretch) const { return mean_of_ == stretch && IsOf(stretch); }
  // By no more than noise, if the camera's motion was what it was advanced by.
  bool IsWhereItWas(const Sighting& sighting) const;
  // As it was seen last, where it should be now.
  const Sighting& expected() const { return expected_; }
  // As most of it was seen since it was moved, there too: what comes out from behind something may
  // show nothing of what went in last.
  const Sighting& fullest() const { return in_mean_ ? expected_ : fullest_; }

  ObjectTrack ToObjectTrack() const;

 private:
  void BeginAgain(const Sighting& sighting);
  void Compare(const Sighting& sighting, double camera_error_m);
  bool IsOff(const Displacement& by) const;
  void StandStill(const Sighting& sighting, const Spot& spot);
  void StartAnew(const Sighting& sighting, const Spot& spot, bool moves, double camera_error_m);

  std::uint64_t id_;
  std::uint64_t mean_of_, seen_in_;  // stretches of steadied_ and place_, of expected_
  std::optional<CaptureTime> first_seen_, last_seen_;
  double seconds_hidden_ = 0;  // since it was seen last
  std::uint32_t times_seen_ = 1;
  bool was_seen_ = true, was_gone_ = false;
  bool left_out_ = false;  // of steadied_, in the last frame that showed it
  Sighting expected_, fullest_;
  std::optional<Sighting> in_mean_;  // the last one of the mean's stretch, where expected_ is not
  SteadiedBox steadied_;
  Spot place_;  // the mean of those that steadied_ is of
  Scatter scatter_;
  Eigen::Vector3f heading_ = Eigen::Vector3f::Zero();  // its last step, of what moves
  std::optional<VelocityFilter> filter_;               // of what moves against the background
};

}  // namespace fovea
