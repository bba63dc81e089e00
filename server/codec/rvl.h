#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <string_view>

namespace fovea::server {

// Depth as RVL codes (Wilson 2017, "Fast Lossless Depth Image Compression") to CV_16UC1; the caller
// has checked the size. Throws std::invalid_argument unless the codes are those of just so many
// pixels. Time: that of reading the codes, whatever they say.
cv::Mat DecodeRvl(std::string_view codes, int width, int height);

// The most bytes that codes of so many pixels have.
std::size_t MaxRvlBytes(std::size_t num_pixels);

}  // namespace fovea::server
