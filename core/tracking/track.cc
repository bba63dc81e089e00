#include "core/tracking/track.h"

#include <algorithm>
#include <cmath>

namespace fovea {
namespace {

// Of the velocity filter: how well one frame tells where a thing is.
double PositionDeviation(const Sighting& sighting) {
  return 0.005 + 0.1 * sighting.box.size_m.norm();
}

// How far a thing that stands seems to be from its place at most: noise, and that another part of
// it is seen.
double StillWithin(const Sighting& sighting, double camera_error_m) {
  return 0.015 + 0.2 * sighting.box.size_m.norm() + 3 * camera_error_m;
}

// Below that, things stand: noise moves them by as much.
constexpr float kSlowest_m_s = 0.05F;
constexpr int kSlowFrames = 5;

const Eigen::Vector3f& Shorter(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return a.squaredNorm() < b.squaredNorm() ? a : b;
}

void Shift(Sighting& sighting, const Eigen::Vector3f& by) {
  sighting.box.center += by;
  sighting.centroid += by;
  for (Eigen::Vector3f& point : sighting.points) point += by;
}

}  // namespace

Track::Track(std::uint64_t id, const Sighting& first, const std::optional<CaptureTime>& at)
    : id_(id),
      first_seen_(at),
      last_seen_(at),
      expected_(first),
      steadied_(first.box),
      steady_centroid_(first.centroid) {}

void Track::Advance(const Eigen::Isometry3f& this_from_last, double seconds) {
  expected_ = Moved(std::move(expected_), this_from_last);
  steadied_.Transform(this_from_last);
  steady_centroid_ = this_from_last * steady_centroid_;
  if (off_) off_ = this_from_last.linear() * *off_;
  off_seconds_ += seconds;
  seconds_hidden_ += seconds;
  if (!filter_) return;
  filter_->Transform(this_from_last);
  const Eigen::Vector3f before = filter_->position();
  // What is moved by a hand behind something does not go on for long.
  constexpr double kLongestMotion_s = 0.5;
  if (seconds_hidden_ > kLongestMotion_s) filter_->Stop();
  filter_->Predict(seconds);
  Shift(expected_, filter_->position() - before);
}

void Track::OnSeen(const Sighting& sighting, double camera_error_m,
                   const std::optional<CaptureTime>& at) {
  if (filter_) {
    FollowMotion(sighting, camera_error_m);
  } else {
    StandStill(sighting);
    const Eigen::Vector3f off = Shorter(sighting.centroid - steady_centroid_,
                                        sighting.box.center - steadied_.mean().center);
    const bool is_off = off.norm() > StillWithin(sighting, camera_error_m);
    // Once may be a mistake of the mask.
    if (is_off && off_ && off_->dot(off) > 0) {
      const auto seconds = static_cast<float>(std::max(off_seconds_, 1e-3));
      const Eigen::Vector3f velocity = (off - *off_) / seconds;
      // Two times may be nearer to each other than their frames were.
      const float within = std::min(1.0F, kFastest_m_s / velocity.norm());
      filter_.emplace(sighting.centroid, within * velocity);
      steadied_ = SteadiedBox(sighting.box);
      off_.reset();
      slow_ = 0;
    } else {
      off_ = is_off ? std::optional(off) : std::nullopt;
      off_seconds_ = 0;
    }
  }
  expected_ = sighting;
  last_seen_ = at;
  ++times_seen_;
  was_seen_ = true;
  seconds_hidden_ = 0;
}

void Track::StandStill(const Sighting& sighting) {
  steadied_.Add(sighting.box);
  const float weight = 1.0F / static_cast<float>(steadied_.count());
  steady_centroid_ += weight * (sighting.centroid - steady_centroid_);
}

void Track::FollowMotion(const Sighting& sighting, double camera_error_m) {
  filter_->Update(sighting.centroid, PositionDeviation(sighting) + camera_error_m);
  steadied_ = SteadiedBox(sighting.box);
  steady_centroid_ = sighting.centroid;
  slow_ = filter_->velocity().norm() < kSlowest_m_s ? slow_ + 1 : 0;
  if (slow_ >= kSlowFrames) filter_.reset();
}

ObjectTrack Track::ToObjectTrack() const {
  return {id_, first_seen_, times_seen_, steadied_.mean(), steadied_.count(), filter_.has_value()};
}

}  // namespace fovea
