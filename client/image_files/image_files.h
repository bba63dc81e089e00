// Images as PNG and JPEG files, by the libraries that the server decodes them with: OpenCV's reader
// of images needs hundreds of megabytes of others on a robot.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <string_view>

namespace fovea::image_files {

// Neither reads more than 2^26 pixels. What they throw is a std::runtime_error that says why: not
// such an image, or not a whole one.

// PNG (any) or JPEG (but CMYK) → CV_8UC3, B first, without alpha, as stored: not turned by EXIF.
cv::Mat DecodeColor(std::string_view file);
// PNG of one channel of 16 bits → CV_16UC1.
cv::Mat DecodeDepth(std::string_view file);

// 8 or 16 bits, one channel, three (B first) or four (B first, alpha last), not empty. Compressed
// little, which takes a tenth of the time.
std::string EncodePng(const cv::Mat& image);
// CV_8UC1 or CV_8UC3 (B first), at most 65500 wide and high. Throws std::runtime_error for larger
// ones.
std::string EncodeJpeg(const cv::Mat& image, int quality);

}  // namespace fovea::image_files
