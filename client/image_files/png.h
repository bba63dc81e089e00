#pragma once

#include <opencv2/core/mat.hpp>
#include <string_view>

namespace fovea::image_files {

bool IsPng(std::string_view file);
// Like DecodeColor, of PNG alone.
cv::Mat DecodePngColor(std::string_view file);

}  // namespace fovea::image_files
