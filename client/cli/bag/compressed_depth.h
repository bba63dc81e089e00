#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace fovea::cli {

// What compressed_depth_image_transport says of its files, "16UC1; compressedDepth rvl".
struct DepthFormat {
  std::string_view encoding, codec;
};
// None of other formats. Without a codec it is of an older version, which knew PNG alone.
std::optional<DepthFormat> ParseDepthFormat(std::string_view format);

// What is behind the parameters that its files begin with.
std::string_view PackedDepth(std::string_view file);

// RVL behind columns and rows → CV_16UC1. Throws std::invalid_argument.
cv::Mat DecodePackedRvl(std::string_view packed);

// Of its depth in metres: PNG or RVL of A / depth + B, where A and B are the last of the
// parameters and 0 is none → CV_32FC1. Throws std::invalid_argument.
cv::Mat InverseDepthInMeters(std::string_view file, std::string_view codec);

}  // namespace fovea::cli
