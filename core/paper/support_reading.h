// What the dominating support surface means for seeds and background (paper section 3.2).
#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "core/paper/paper_options.h"
#include "core/seeds/salient_positions.h"

namespace fovea::paper {

// The seeds that do not lie on the surface, or below it where the options say so; the others are
// appended to `removed`.
std::vector<Seed> SeedsOffSupport(const std::optional<SupportSurface>& support,
                                  const std::vector<Seed>& seeds, const PaperOptions& options,
                                  std::vector<RemovedSeed>& removed);

// The points whose background probability is one: CV_8UC1 of the image's size, 255 on the surface,
// and below it where the options say so; empty without a surface or where that is hard background.
cv::Mat PointsOfSupport(const cv::Mat& points, const std::optional<SupportSurface>& support,
                        const PaperOptions& options);

// One entry a voxel: 1 for what can only be background, outside of the region and, as a reading, on
// the surface and below it.
std::vector<char> CertainBackground(const VoxelGrid& grid, const std::vector<Support>& supports,
                                    const CameraIntrinsics& intrinsics,
                                    const PaperOptions& options);

// Seeds at given pixels instead of those of the saliency maps.
SalientPositions SeedsAt(const std::vector<cv::Point>& pixels, const cv::Mat& points);

}  // namespace fovea::paper
