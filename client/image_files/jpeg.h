#pragma once

#include <opencv2/core/mat.hpp>
#include <string_view>

namespace fovea::image_files {

// Like DecodeColor, of JPEG alone.
cv::Mat DecodeJpeg(std::string_view file);

}  // namespace fovea::image_files
