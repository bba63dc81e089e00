#pragma once

#include <opencv2/core/mat.hpp>
#include <string_view>

#include "server/codec/size_limits.h"

namespace fovea::server {

// Both check the size in the file's header before anything of that size is allocated, and throw
// std::invalid_argument for a file that is not whole or not of the stated kind.

// An 8-bit (or smaller) grey, palette, RGB or RGBA file to CV_8UC3, R first; alpha is dropped.
cv::Mat DecodePngColor(std::string_view file, const SizeLimits& limits);

// A 16-bit single-channel file to CV_16UC1.
cv::Mat DecodePngGray16(std::string_view file, const SizeLimits& limits);

}  // namespace fovea::server
