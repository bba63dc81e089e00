#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

namespace fovea::cli {

// All throw std::runtime_error that names the file.

// Of up to 1 GiB.
std::string ReadFile(const std::string& path);
// The same of the file that a flag names, which the error names, too.
std::string ReadFlagFile(const std::string& flag, const std::string& path);
void WriteFile(const std::string& path, const std::string& bytes);

// CV_8UC3, B first, as stored (no EXIF orientation).
cv::Mat DecodeColor(const std::string& file, const std::string& path);
// CV_16UC1.
cv::Mat DecodeDepth(const std::string& file, const std::string& path);

// Encodes by the extension of `path`.
void WriteImage(const std::string& path, const cv::Mat& image);

}  // namespace fovea::cli
