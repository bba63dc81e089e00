// The dominating horizontal surface that objects stand on (paper section 3.2).
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "core/types/detections.h"

namespace fovea {

struct SupportOptions {
  // Points whose normal is within this angle of the vertical may lie on the surface; degrees.
  double max_angle_deg = 15;
  // The dominating height is the fullest interval of this width; metres.
  double height_bin_m = 0.01;
  // Points within tolerance_m + tolerance_per_m · z² of the surface (z: distance along the optical
  // axis in metres) belong to it; metres, 1/metres. The second follows structured-light noise.
  double tolerance_m = 0.01;
  double tolerance_per_m = 0.0;
  // Number of least-squares fits that refine the plane; 0 keeps it exactly perpendicular to
  // gravity.
  int plane_fits = 3;
  // Fewer points than this share of all points make no surface; 0 … 1.
  double min_share = 0.05;
};

// Finds the height at which most of the points with a vertical normal lie and fits the surface
// there. `points`, `normals`: CV_32FC3 in the camera frame, NaN = none; `gravity`: unit vector
// that points down. No surface where too few points agree.
std::optional<SupportSurface> FindSupportSurface(const cv::Mat& points, const cv::Mat& normals,
                                                 const Eigen::Vector3f& gravity,
                                                 const SupportOptions& options = {});

// How far from the surface a point at distance z along the optical axis still belongs to it.
float SupportTolerance(float z_m, const SupportOptions& options);

// Height of every point above the surface. Returns CV_32FC1, metres, NaN = none.
cv::Mat HeightsAbove(const SupportSurface& surface, const cv::Mat& points);

}  // namespace fovea
