// Where a thing is, and whether it was moved.
#pragma once

#include <Eigen/Geometry>

#include "core/tracking/sighting.h"

namespace fovea {

// What of a sighting, or of the mean of several, tells that.
struct Spot {
  Eigen::Vector3f center, centroid;      // of the box, of the visible points
  Eigen::Matrix3f center_covariance;     // as the box has it; where it has none, see SpotOf
  Eigen::Vector3f size_m, size_sigma_m;  // the longer one of the level sizes first
  float visible_m2 = 0;
  double camera_variance_m2 = 0;  // of where it is now, by motions of the camera that add up
};

// Of a box without uncertainty, whose depth is missing, any displacement up to 15 mm and a fifth of
// its diagonal is noise until its scatter is known, and any size up to a third of that.
Spot SpotOf(const Sighting& sighting);
// The same seen from another frame: p_to = to_from_own · p.
Spot Moved(Spot spot, const Eigen::Isometry3f& to_from_own);
// Takes so much, 0 … 1, of `other` in.
void Mix(Spot& spot, const Spot& other, float weight);

// It shows as much of itself, and has the same sizes by their standard deviations: no other mask.
bool LooksAlike(const Spot& a, const Spot& b);

// How much one thing's places jump from frame to frame while it stands, as shares of the variances
// that they are expected to have. They begin with 1, which counts as kFirstWeight frames, and are
// the means of the last kLongestWeight then.
struct Scatter {
  double of_center = 1, of_centroid = 1;
  int weight = kFirstWeight;

  static constexpr int kFirstWeight = 4, kLongestWeight = 20;
};

// From a sighting or a mean of several to another sighting.
struct Displacement {
  // Farther than this many standard deviations it was moved.
  static constexpr double kMovedBeyond = 3.5;

  Eigen::Vector3f of_center, of_centroid;         // m
  double center_sigmas = 0, centroid_sigmas = 0;  // by the scatter and the camera's motion

  // Both by more than so many standard deviations and the same way: where another part of it is
  // seen, or its shape is taken for another, one of the two stays.
  bool IsBeyond(double sigmas) const;
};

// `camera_error_m`: what is not known of the camera's motion between the two.
Displacement Between(const Spot& from, const Spot& to, const Scatter& scatter,
                     double camera_error_m);
// It stood in two frames in turn.
void Learn(Scatter& scatter, const Spot& last, const Spot& now);

}  // namespace fovea
