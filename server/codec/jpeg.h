#pragma once

#include <opencv2/core/mat.hpp>
#include <string_view>

#include "server/codec/size_limits.h"

namespace fovea::server {

// Decodes a JPEG file to CV_8UC3, R first, as stored (an EXIF orientation is not applied: the
// camera model belongs to the stored rows and columns). The size in its header is checked before
// anything of that size is allocated. Throws std::invalid_argument for a file that is not whole,
// and for one of more than 64 scans.
cv::Mat DecodeJpeg(std::string_view file, const SizeLimits& limits);

}  // namespace fovea::server
