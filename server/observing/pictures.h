// What of frames is shown.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "fovea/v1/frame.pb.h"
#include "fovea/v1/observation_service.pb.h"
#include "server/observing/sight.h"

namespace fovea::server {

// A JPEG file of a CV_8UC3 image, R first. Throws std::runtime_error where it cannot be made.
std::string JpegOf(const cv::Mat& color_rgb, int quality);

// The colour image as the robot sent it: the same file where it was a JPEG. Throws like the
// decoders.
std::string PictureOf(const v1::ColorImage& color, std::uint64_t max_pixels);

// A JPEG file of at most 320 pixels a side.
std::string PreviewOf(const v1::ColorImage& color, std::uint64_t max_pixels);

// Of CV_32FC1 in metres. The unit is 1 mm, or as much more as the farthest pixel needs.
v1::WatchedDepth DepthOf(const RgbdFrame& decoded);

}  // namespace fovea::server
