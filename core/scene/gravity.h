// The direction of gravity from the surfaces of a room (Gupta et al. 2013, which the paper uses in
// section 3.2).
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "core/depth/normals.h"
#include "core/types/detections.h"

namespace fovea {

struct GravityOptions {
  // Normals within this angle of the estimate count as floor-like, those within it of the
  // horizon as wall-like; first and second stage. Gupta: 45° and 15°.
  double coarse_angle_deg = 45;
  double fine_angle_deg = 15;
  // Iterations of each stage. Gupta: 5.
  int iterations = 5;
  // The normals that it is estimated from. Gupta: windows of 21×21 pixels.
  NormalOptions normals{.window_radius_px = 10, .step_px = 6};
  // Start from this many camera pitches between level and straight down and keep the direction
  // that explains most normals; 1 starts from the camera's y axis alone, as Gupta does, whose
  // first gate a camera pitched by more than 45° leaves.
  int num_starts = 1;
};

// The direction that is most aligned with, or orthogonal to, as many normals as possible, starting
// from the camera's y axis: each iteration takes the eigenvector of the smallest eigenvalue of
// Σ_wall n nᵀ − Σ_floor n nᵀ.
//
// `normals`: CV_32FC3 unit vectors in the camera frame, NaN = none. Returns a unit vector in the
// camera frame that points down (its y is that of the start's sign); the start where no normal
// counts.
Eigen::Vector3f EstimateGravity(const cv::Mat& normals, const GravityOptions& options = {});

// `given` where the frame tells it, else the estimate from `normals`; without any, it is assumed.
Gravity FindGravity(const std::optional<Eigen::Vector3f>& given, const cv::Mat& normals,
                    const GravityOptions& options = {});

}  // namespace fovea
