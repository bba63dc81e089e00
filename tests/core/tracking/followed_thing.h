// A thing that a track follows.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>

#include "core/tracking/track.h"

namespace fovea::testing {

// A cube of a decimetre, a metre away, whose place and sizes are known to a millimetre or two.
inline Sighting ThingAt(float x_m, float y_m = 0) {
  const Eigen::Vector3f center(x_m, y_m, 1);
  BoxUncertainty uncertainty;
  uncertainty.pose_covariance.diagonal().setConstant(0.0015F * 0.0015F);
  uncertainty.size_sigma_m.setConstant(0.002F);
  return {.box = {.center = center, .size_m = {0.1F, 0.1F, 0.1F}},
          .uncertainty = uncertainty,
          .centroid = center,
          .visible_m2 = 0.01F,
          .points = {center}};
}

inline const Eigen::Isometry3f kStands = Eigen::Isometry3f::Identity();

struct Followed {
  explicit Followed(int frames = 4) {
    for (int i = 1; i < frames; ++i) See(0);
  }

  void Wait(double seconds, const Eigen::Isometry3f& this_from_last = kStands,
            double adding_up_m = 0) {
    track.Advance(this_from_last, seconds, adding_up_m);
  }
  ObjectTrack See(const Sighting& sighting, double camera_error_m = 0) {
    Wait(0.1);
    track.OnSeen(sighting, camera_error_m, std::nullopt);
    return track.ToObjectTrack();
  }
  ObjectTrack See(float x_m, double camera_error_m = 0) {
    return See(ThingAt(x_m), camera_error_m);
  }
  ObjectTrack SeeIn(std::uint64_t stretch, const Sighting& sighting) {
    track.OnSeen(sighting, 0, std::nullopt, stretch);
    return track.ToObjectTrack();
  }
  float SteadyX() const { return track.ToObjectTrack().steadied_box.center.x(); }

  Track track{1, ThingAt(0), std::nullopt};
};

}  // namespace fovea::testing
