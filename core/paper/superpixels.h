// Regular superpixels of a single-channel map (SLIC, Achanta et al. 2012).
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

namespace fovea::paper {

struct Superpixel {
  float x_px = 0;  // centroid
  float y_px = 0;
  float value = 0;  // mean of the map
  int pixels = 0;   // 0: none of the map's values fell to it; the other fields mean nothing
};

struct Superpixels {
  cv::Mat labels;  // CV_32SC1, index into `all`; -1 where the map has no value
  std::vector<Superpixel> all;
};

// Divides a map into about `count` superpixels on a grid. A pixel chooses among the superpixels of
// the nine grid cells about it the one that is closest in value² + (compactness/cell size)²·px².
// Parts of a superpixel may be apart from each other. Deterministic. Cost: five passes over the map
// with nine candidates for each pixel.
//
// `map`: CV_32FC1; a value that is not finite = none. `count` ≥ 1, `compactness` in the map's unit.
Superpixels DivideIntoSuperpixels(const cv::Mat& map, int count, float compactness);

}  // namespace fovea::paper
