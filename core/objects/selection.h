// Which segments become objects, how sure that is, and in which order they are reported.
#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/depth/seen_area.h"
#include "core/types/blocks.h"
#include "core/types/pixel_runs.h"

namespace fovea {

struct SelectionOptions {
  // Segments with fewer mask pixels are dropped; at an image of 640×480 (scaled with its area, but
  // never fewer than 20).
  double min_pixels = 300;
  // Only the most salient ones are kept, up to this many, as if nothing else were there: what rests
  // on them is not known of then; 0: all.
  int max_objects = 0;
};

struct Candidate {
  int label = 0;
  PixelRuns pixels;
  std::size_t num_pixels = 0;
  float confidence = 0;
  float saliency = 0;      // mean over the pixels
  bool truncated = false;  // ends with the measured area or the region of interest
};

// What is known of the labels: of label k at k − 1.
struct LabelFacts {
  const std::vector<float>& confidences;
  std::vector<char> is_cut_by_region = {};  // empty: none is
};

struct Selection {
  std::vector<Candidate> candidates;  // by falling confidence, then pixels, then by label
  std::size_t num_too_small = 0;
  std::size_t num_less_salient = 0;  // beyond max_objects
};

// `labels`: CV_16UC1, 0 = background; `saliency`: CV_32FC1 in [0, 1]; `area`: what the camera sees
// of the image. Cost: proportional to the image.
Selection SelectObjects(const cv::Mat& labels, const LabelFacts& facts, const BlockImage& saliency,
                        const SeenArea& area, const SelectionOptions& options = {});

}  // namespace fovea
