// From a saliency map to the positions at which objects are looked for (paper section 3.2).
#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "core/types/detections.h"

namespace fovea {

struct SeedOptions {
  // Radius of the disk of the opening by reconstruction; pixels, at an image width of 640 (scaled
  // with the width). Paper: "a 20-pixel disk".
  double disk_radius_px = 20;
  // 1: a seed is the measured pixel of its flat peak nearest to the peak's centroid. 0: it is the
  // centroid itself and is lost where that has no depth.
  bool on_peak = true;
  // Which of the maps give seeds, to see what each contributes. Paper: both.
  bool from_color = true;
  bool from_depth = true;
};

struct SeedCandidates {
  std::vector<Seed> seeds;               // in row-major order of their peaks
  std::vector<cv::Point> without_depth;  // centroids of peaks that gave no seed for want of depth
};

// Opening by reconstruction with a disk, regional maxima, one seed for each flat peak.
//
// `saliency`: CV_32FC1 without NaN, constant in square blocks of `block_px` pixels, which saves
// time if they are more than one; `points`: CV_32FC3 of the same size, NaN = none.
SeedCandidates FindSeeds(const cv::Mat& saliency, const cv::Mat& points, Seed::Source source,
                         const SeedOptions& options = {}, int block_px = 1);

}  // namespace fovea
