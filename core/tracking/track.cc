#include "core/tracking/track.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fovea {
namespace {

// Of the velocity filter: how well one frame tells where a thing is.
double PositionDeviation(const Sighting& sighting) {
  return 0.005 + 0.1 * sighting.box.size_m.norm();
}

void Shift(Sighting& sighting, const Eigen::Vector3f& by) {
  sighting.box.center += by;
  sighting.centroid += by;
  for (Eigen::Vector3f& point : sighting.points) point += by;
}

}  // namespace

Track::Track(std::uint64_t id, const Sighting& first, const std::optional<CaptureTime>& at,
             std::uint64_t stretch)
    : id_(id),
      mean_of_(stretch),
      seen_in_(stretch),
      first_seen_(at),
      last_seen_(at),
      expected_(first),
      fullest_(first),
      steadied_(first.box),
      place_(SpotOf(first)) {}

void Track::Advance(const Eigen::Isometry3f& this_from_last, double seconds, double adding_up_m) {
  expected_ = Moved(std::move(expected_), this_from_last);
  fullest_ = Moved(std::move(fullest_), this_from_last);
  if (in_mean_) in_mean_ = Moved(*std::move(in_mean_), this_from_last);
  steadied_.Transform(this_from_last);
  place_ = Moved(place_, this_from_last);
  place_.camera_variance_m2 += adding_up_m * adding_up_m;
  heading_ = this_from_last.linear() * heading_;
  seconds_hidden_ += seconds;
  if (!filter_) return;
  filter_->Transform(this_from_last);
  const Eigen::Vector3f before = filter_->position();
  // What is moved by a hand behind something does not go on for long.
  constexpr double kLongestMotion_s = 0.5;
  if (seconds_hidden_ > kLongestMotion_s) filter_->Stop();
  filter_->Predict(seconds);
  Shift(expected_, filter_->position() - before);
  Shift(fullest_, filter_->position() - before);
}

void Track::Enter(std::uint64_t stretch) {
  if (stretch != mean_of_ || !in_mean_) return;
  expected_ = *std::exchange(in_mean_, std::nullopt);
  seen_in_ = mean_of_;
}

void Track::OnSeen(const Sighting& sighting, double camera_error_m,
                   const std::optional<CaptureTime>& at, std::uint64_t stretch) {
  if (stretch != mean_of_ && stretch == seen_in_) BeginAgain(expected_);
  if (stretch == mean_of_) {
    Compare(sighting, camera_error_m);
  } else if (!in_mean_) {
    // What moves does not go on for long, and nobody knows which way.
    filter_.reset();
    in_mean_ = std::move(expected_);
  }
  expected_ = sighting;
  seen_in_ = stretch;
  last_seen_ = at;
  ++times_seen_;
  was_seen_ = true;
  was_gone_ = false;
  seconds_hidden_ = 0;
}

bool Track::IsWhereItWas(const Sighting& sighting) const {
  return !Between(place_, SpotOf(sighting), scatter_, 0).IsBeyond(Displacement::kMovedBeyond);
}

// As what stands: nothing is known of how it came there.
void Track::BeginAgain(const Sighting& sighting) {
  steadied_.StartAnew(sighting.box);
  place_ = SpotOf(sighting);
  fullest_ = sighting;
  filter_.reset();
  left_out_ = false;
  mean_of_ = seen_in_;
  in_mean_.reset();
}

void Track::Compare(const Sighting& sighting, double camera_error_m) {
  const Spot spot = SpotOf(sighting);
  const Displacement by = Between(place_, spot, scatter_, camera_error_m);
  const bool is_off = IsOff(by), looks_alike = LooksAlike(place_, spot);
  // Where its mask changed as well, that may be a mistake.
  const bool leave_out = is_off && !filter_ && !left_out_ && !looks_alike && steadied_.count() > 1;
  if (!is_off) {
    StandStill(sighting, spot);
  } else if (!leave_out) {
    const Displacement step = Between(SpotOf(expected_), spot, scatter_, camera_error_m);
    const bool goes_on = left_out_ && step.IsBeyond(Displacement::kMovedBeyond);
    StartAnew(sighting, spot, filter_ || looks_alike || goes_on, camera_error_m);
    heading_ = by.of_center.normalized();
  }
  left_out_ = leave_out;
}

// What moves is off by half of that, too, where it goes on the same way.
bool Track::IsOff(const Displacement& by) const {
  if (by.IsBeyond(Displacement::kMovedBeyond)) return true;
  return filter_ && by.IsBeyond(Displacement::kMovedBeyond / 2) &&
         by.of_center.dot(heading_) > by.of_center.norm() / 2;
}

void Track::StandStill(const Sighting& sighting, const Spot& spot) {
  if (!filter_ && !left_out_) Learn(scatter_, SpotOf(expected_), spot);
  filter_.reset();
  steadied_.Add(sighting.box);
  Mix(place_, spot, 1.0F / static_cast<float>(steadied_.count()));
  if (sighting.visible_m2 >= fullest_.visible_m2) fullest_ = sighting;
}

void Track::StartAnew(const Sighting& sighting, const Spot& spot, bool moves,
                      double camera_error_m) {
  if (filter_) {
    filter_->Update(sighting.centroid, PositionDeviation(sighting) + camera_error_m);
  } else if (moves) {
    // It may have been pushed once: what comes next tells how fast it is.
    filter_.emplace(sighting.centroid, Eigen::Vector3f::Zero());
  }
  if (moves) {
    steadied_ = SteadiedBox(sighting.box);
    fullest_ = sighting;
  } else {
    steadied_.StartAnew(sighting.box);
  }
  place_ = spot;
}

ObjectTrack Track::ToObjectTrack() const {
  if (seen_in_ != mean_of_) return {id_, first_seen_, times_seen_, expected_.box, 1, false};
  return {id_, first_seen_, times_seen_, steadied_.mean(), steadied_.count(), filter_.has_value()};
}

}  // namespace fovea
