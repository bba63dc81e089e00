#include "core/tracking/tracker.h"

#include <algorithm>
#include <utility>

#include "core/tracking/association.h"
#include "core/tracking/hidden.h"
#include "core/tracking/sighting.h"

namespace fovea {
namespace {

double Seconds(const CaptureTime& from, const CaptureTime& to) {
  return static_cast<double>(to.seconds - from.seconds) + 1e-9 * (to.nanos - from.nanos);
}

// Sums of tenths are not exact.
bool IsKept(const Track& track) { return track.seconds_hidden() < Tracker::kKeptHidden_s + 1e-6; }

}  // namespace

void Tracker::Add(const RgbdFrame& frame, const FrameContext& context, Detections& detections) {
  const CameraPath::Place place = path_.Add(frame, detections.labels, context.camera_pose);
  const double seconds = SecondsUntil(context.captured_at);
  const Eigen::Isometry3f this_from_last = place.motion.last_from_this.inverse().cast<float>();
  // Poses are all of one frame of reference: what they err by does not add up.
  const bool is_given = place.motion.source == CameraMotionSource::kGiven;
  const double adding_up_m = is_given ? 0 : place.error_m;
  for (Track& track : tracks_) track.Advance(this_from_last, seconds, adding_up_m);
  std::erase_if(tracks_, [](const Track& track) { return !track.was_seen() && !IsKept(track); });
  Match(SightingsOf(detections, frame.intrinsics, kMaxTracks), place, frame, context, detections);
  Forget();
  detections.tracking = {epoch_, place.motion, Hidden(frame)};
}

double Tracker::SecondsUntil(const std::optional<CaptureTime>& time) {
  const bool goes_on = time && last_time_ && *time > *last_time_;
  // Nothing is kept for longer, so that it does not matter how much longer it was.
  const double seconds =
      goes_on ? std::min(Seconds(*last_time_, *time), 2 * kKeptHidden_s) : 1 / kFramesPerSecond;
  last_time_ = time;
  return seconds;
}

void Tracker::Match(const std::vector<Sighting>& sightings, const CameraPath::Place& place,
                    const RgbdFrame& frame, const FrameContext& context, Detections& detections) {
  const std::vector<int> track_of_sighting =
      Associate(tracks_, sightings, {detections.labels, frame.intrinsics, place.error_m});
  for (Track& track : tracks_) track.OnMissed();
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    const int t = track_of_sighting[i];
    if (t >= 0) {
      tracks_[t].OnSeen(sightings[i], place.error_m, context.captured_at);
      detections.objects[i].track = tracks_[t].ToObjectTrack();
    } else {
      tracks_.emplace_back(++last_id_, sightings[i], context.captured_at);
      detections.objects[i].track = tracks_.back().ToObjectTrack();
    }
  }
}

void Tracker::Forget() {
  constexpr std::uint32_t kConfirmed = 2;
  std::erase_if(tracks_, [](const Track& track) {
    const bool is_kept = track.times_seen() >= kConfirmed && IsKept(track);
    return !track.was_seen() && !is_kept;
  });
  if (tracks_.size() <= kMaxTracks) return;
  std::stable_sort(tracks_.begin(), tracks_.end(), [](const Track& a, const Track& b) {
    return a.seconds_hidden() < b.seconds_hidden();
  });
  tracks_.erase(tracks_.begin() + kMaxTracks, tracks_.end());
  std::sort(tracks_.begin(), tracks_.end(),
            [](const Track& a, const Track& b) { return a.id() < b.id(); });
}

std::vector<HiddenTrack> Tracker::Hidden(const RgbdFrame& frame) const {
  std::vector<HiddenTrack> hidden;
  for (const Track& track : tracks_) {
    if (track.was_seen()) continue;
    hidden.push_back({track.id(), track.expected().box, track.last_seen(), track.times_seen(),
                      ReasonOf(track.expected(), frame)});
  }
  return hidden;
}

}  // namespace fovea
