#pragma once

#include <cstdint>
#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace fovea::cli {

// All throw std::runtime_error that names the file.

// No server takes a larger message; certificates, tokens, calibrations and lists are smaller.
constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 30;
constexpr std::uintmax_t kLargestText = std::uintmax_t{16} << 20;

// Some editors begin files with it.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// Of up to `most` bytes, so that a device without an end is refused, too.
std::string ReadFile(const std::string& path, std::uintmax_t most = kLargestFile);
// Text of a file that comes with a folder: a pipe would be waited for, and a device may have no
// end.
std::string ReadTextOfFolder(const std::string& path);
// Text of the file that a flag names, which the error names, too.
std::string ReadFlagFile(const std::string& flag, const std::string& path);
void WriteFile(const std::string& path, const std::string& bytes);

// Of a folder, sorted.
std::vector<std::filesystem::path> FilesIn(const std::filesystem::path& folder);

// CV_8UC3, B first, as stored (no EXIF orientation).
cv::Mat DecodeColor(const std::string& file, const std::string& path);
// CV_16UC1.
cv::Mat DecodeDepth(const std::string& file, const std::string& path);

// As PNG or JPEG, by the ending of `path`.
void WriteImage(const std::string& path, const cv::Mat& image);

}  // namespace fovea::cli
