// Images that arrive as bare rows. All throw std::invalid_argument unless the number of bytes is
// exactly what the size needs; the caller has checked the size itself.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string_view>

namespace fovea::server {

// Copies rows without padding into a matrix of the given OpenCV type. `kind` is for the text of
// the error: "has 10 bytes, 640x480 RGB8 needs 921600".
cv::Mat ImageFromRows(std::string_view bytes, int width, int height, int type, const char* kind);

// Unsigned 16-bit depth in units of `unit_m` to metres; 0 becomes NaN.
cv::Mat MetersFrom16U(const cv::Mat& depth, double unit_m);

// Float depth in metres, in which infinite values, NaN and values <= 0 become NaN.
cv::Mat MetersFrom32F(const cv::Mat& depth);

}  // namespace fovea::server
