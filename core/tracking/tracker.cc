#include "core/tracking/tracker.h"

#include <algorithm>
#include <utility>

#include "core/tracking/association.h"
#include "core/tracking/hidden.h"
#include "core/tracking/sighting.h"

namespace fovea {
namespace {

// Sums of tenths are not exact.
bool IsOver(const Track& track) {
  return !track.was_seen() && track.seconds_hidden() >= Tracker::kKeptHidden_s + 1e-6;
}

}  // namespace

void Tracker::Add(const RgbdFrame& frame, const FrameContext& context, Detections& detections) {
  CameraPath::Place place = path_.Add(frame, detections.labels, context.camera_pose);
  // Nothing is kept for longer, so that it does not matter how much longer it was.
  const double seconds = std::min(clock_.Add(context.captured_at), 2 * kKeptHidden_s);
  const Eigen::Isometry3f this_from_last = place.motion.last_from_this.inverse().cast<float>();
  // Poses are all of one frame of reference: what they err by does not add up.
  const bool is_given = place.motion.source == CameraMotionSource::kGiven;
  const double adding_up_m = is_given || place.is_guess() ? 0 : place.error_m;
  for (Track& track : tracks_) track.Advance(this_from_last, seconds, adding_up_m);
  for (Track& track : tracks_) track.Enter(place.stretch);
  std::erase_if(tracks_, IsOver);
  place = Match(SightingsOf(detections, frame.intrinsics, kMaxTracks), place, frame, context,
                detections);
  last_stretch_ = place.stretch;
  Forget();
  detections.tracking = {epoch_, place.motion, Hidden(frame, place.stretch, detections.incomplete)};
}

CameraPath::Place Tracker::Match(const std::vector<Sighting>& sightings, CameraPath::Place place,
                                 const RgbdFrame& frame, const FrameContext& context,
                                 Detections& detections) {
  const std::vector<int> track_of_sighting =
      Associate(tracks_, sightings, {detections.labels, frame.intrinsics, place.error_m});
  if (place.is_guess() && MostAreWhereTheyWere(sightings, track_of_sighting)) {
    place = path_.TakeGuessForTrue();
  }
  for (Track& track : tracks_) track.OnMissed();
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    const int t = track_of_sighting[i];
    if (t >= 0) {
      const double error_m = place.ErrorAt_m(sightings[i].centroid.norm());
      tracks_[t].OnSeen(sightings[i], error_m, context.captured_at, place.stretch);
      detections.objects[i].track = tracks_[t].ToObjectTrack();
    } else {
      tracks_.emplace_back(++last_id_, sightings[i], context.captured_at, place.stretch);
      detections.objects[i].track = tracks_.back().ToObjectTrack();
    }
  }
  return place;
}

// As before a table without a pattern: things tell what the rest of the picture does not.
bool Tracker::MostAreWhereTheyWere(const std::vector<Sighting>& sightings,
                                   const std::vector<int>& track_of_sighting) const {
  std::size_t known = 0, there = 0;
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    if (track_of_sighting[i] < 0) continue;
    const Track& track = tracks_[track_of_sighting[i]];
    if (!track.HasMeanOf(last_stretch_)) continue;
    ++known;
    if (track.IsWhereItWas(sightings[i])) ++there;
  }
  return 2 * there > known;
}

void Tracker::Forget() {
  std::erase_if(tracks_, IsOver);
  if (tracks_.size() <= kMaxTracks) return;
  std::stable_sort(tracks_.begin(), tracks_.end(), [](const Track& a, const Track& b) {
    return a.seconds_hidden() < b.seconds_hidden();
  });
  tracks_.erase(tracks_.begin() + kMaxTracks, tracks_.end());
  std::sort(tracks_.begin(), tracks_.end(),
            [](const Track& a, const Track& b) { return a.id() < b.id(); });
}

std::vector<HiddenTrack> Tracker::Hidden(const RgbdFrame& frame, std::uint64_t stretch,
                                         bool incomplete) {
  std::vector<HiddenTrack> hidden;
  for (Track& track : tracks_) {
    if (track.was_seen()) continue;
    HiddenReason reason =
        track.IsOf(stretch) ? ReasonOf(track.expected(), frame) : HiddenReason::kNotDetected;
    if (reason == HiddenReason::kGone) track.OnGone();
    if (track.times_seen() < 2) continue;
    // It may be where nobody looked.
    if (reason == HiddenReason::kGone && incomplete) reason = HiddenReason::kNotDetected;
    hidden.push_back(
        {track.id(), track.expected().box, track.last_seen(), track.times_seen(), reason});
  }
  return hidden;
}

}  // namespace fovea
