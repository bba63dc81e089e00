// What tracking keeps of one detected object.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "core/types/detections.h"
#include "core/types/rgbd_frame.h"

namespace fovea {

struct Sighting {
  int label = 0;         // in its frame's label image
  float confidence = 0;  // 0 … 1
  OrientedBox box;
  std::optional<BoxUncertainty> uncertainty = {};      // of the box
  Eigen::Vector3f centroid = Eigen::Vector3f::Zero();  // of the visible points
  Eigen::Vector3f lab = Eigen::Vector3f::Zero();       // mean colour, CIELAB: L 0 … 100, a and b
  // What of it faces the camera: the area of its pixels at their depth.
  float visible_m2 = 0;
  // A sample of its visible points, not empty, each of which stands for the same share of it.
  std::vector<Eigen::Vector3f> points;
};

// At most so many points are kept of an object: an overlap is good to some 3 % then.
constexpr std::size_t kMaxSightingPoints = 256;

// Of each of the first `max_count` objects, which are the most confident; camera frame.
std::vector<Sighting> SightingsOf(const Detections& detections, const CameraIntrinsics& intrinsics,
                                  std::size_t max_count);

// The same seen from another frame: p_to = to_from_own · p.
Sighting Moved(Sighting sighting, const Eigen::Isometry3f& to_from_own);
OrientedBox Moved(OrientedBox box, const Eigen::Isometry3f& to_from_own);

}  // namespace fovea
