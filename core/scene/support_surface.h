// The level surfaces that objects stand on (paper section 3.2).
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "core/depth/normals.h"
#include "core/scene/footprint.h"
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
  // Where the points of a surface scatter less, or more, than the tolerance allows for, things
  // stand on it from this many standard deviations above it (core/scene/surface_scatter.h); 0:
  // always from the tolerance.
  double tolerance_sigmas = 0;
  // Number of least-squares fits that refine the plane; 0 keeps it exactly perpendicular to
  // gravity.
  int plane_fits = 3;
  // Number of further fits, each to the points about the height of most of those within the
  // tolerance, so that low things on the surface do not lift or tilt it. 0: none, as in the paper.
  int common_height_fits = 0;
  // Fewer points than this share of all points make no surface; 0 … 1. Tells whether there is a
  // surface at all, so it is asked of the first only.
  double min_share = 0.05;
  // Up to this many surfaces are looked for, the fullest first. Paper: 1, "the dominating".
  int max_surfaces = 1;
  // Surfaces, and connected parts of one, with less visible area carry nothing: the top of a box
  // is level as well. Square metres.
  double min_area_m2 = 0;
  // Things stand on a surface only within its footprint grown by this; metres. 0: everywhere above
  // it, as in the paper.
  double footprint_margin_m = 0;
  // Points higher above every surface than this belong to no object; metres.
  double max_height_m = 100;
};

struct Support {
  SupportSurface surface;
  Footprint footprint;
  // What stands on the surface begins above this share of the tolerance; 0.35 … 2.5.
  float tolerance_share = 1;

  // What is no farther from it than this share of the tolerance, on either side, may be noise.
  float LargestShare() const { return std::max(1.0F, tolerance_share); }
};

// Finds the heights at which most of the points with a vertical normal lie and fits a surface
// there. `points`: CV_32FC3, NaN = none; both in the camera frame; `gravity`: unit vector that
// points down. The one with most points first; empty where too few points agree.
std::vector<Support> FindSupports(const cv::Mat& points, const NormalMap& normals,
                                  const Eigen::Vector3f& gravity,
                                  const SupportOptions& options = {});

// Fits the planes of the supports anew to those of the points that lie on them, which is for points
// that are truer than those by which they were found.
void RefitSurfaces(const std::vector<Eigen::Vector3f>& points, const SupportOptions& options,
                   std::vector<Support>& supports);

// How far from the surface a point at distance z along the optical axis still belongs to it.
float SupportTolerance(float z_m, const SupportOptions& options);

// The nearest of the supports below a point on which it may stand: inside its footprint, above its
// share of the tolerance and not higher than max_height_m. None for points on a surface, below all,
// or beside.
std::optional<std::size_t> SupportBelow(const std::vector<Support>& supports,
                                        const Eigen::Vector3f& point,
                                        const SupportOptions& options);

// Whether a point lies on one of the supports: inside its footprint and within its tolerance, or
// its share of it where that is larger.
bool IsOnSupport(const std::vector<Support>& supports, const Eigen::Vector3f& point,
                 const SupportOptions& options);

}  // namespace fovea
