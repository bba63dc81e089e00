// Where something stands out in colour or in depth: the candidates for seeds (paper section 3.2).
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/seeds/saliency_seeds.h"

namespace fovea {

struct SalientPositions {
  std::vector<Seed> seeds;           // of the colour map, then of the depth map
  std::vector<RemovedSeed> removed;  // likewise; peaks without depth
};

// The seeds of both maps. `color_saliency`, `depth_saliency`: as of StrengthSaliency and
// DepthSaliency, constant in blocks of `color_block_px` and `depth_block_px`; `points`: CV_32FC3 of
// the same size, NaN = none. Fills what `counts` has of salient positions.
SalientPositions FindSalientPositions(const cv::Mat& color_saliency, int color_block_px,
                                      const cv::Mat& depth_saliency, int depth_block_px,
                                      const cv::Mat& points, const SeedOptions& options,
                                      Diagnostics& counts);

}  // namespace fovea
