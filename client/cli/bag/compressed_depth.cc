#include "client/cli/bag/compressed_depth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "client/cli/bag/byte_reader.h"
#include "client/image_files/image_files.h"
#include "client/image_files/limits.h"
#include "client/rvl.h"

namespace fovea::cli {
namespace {

constexpr std::size_t kParameters = 12;  // an enumeration, A and B

cv::Mat DecodePackedPng(std::string_view packed) {
  try {
    return image_files::DecodeDepth(packed);
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument(error.what());
  }
}

// A few bytes are the RVL of any number of pixels that were not measured.
void CheckRvlSize(std::uint32_t width, std::uint32_t height) {
  if (width == 0 || height == 0) throw std::invalid_argument("an image in RVL has no pixels");
  try {
    image_files::CheckSize(width, height);
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument(std::string("an image in RVL: ") + error.what());
  }
}

}  // namespace

std::optional<DepthFormat> ParseDepthFormat(std::string_view format) {
  constexpr std::string_view kTransport = "; compressedDepth";
  const std::size_t at = format.find(kTransport);
  if (at == std::string_view::npos) return std::nullopt;
  std::string_view codec = format.substr(at + kTransport.size());
  codec.remove_prefix(std::min(codec.find_first_not_of(' '), codec.size()));
  return DepthFormat{format.substr(0, at), codec.empty() ? "png" : codec};
}

std::string_view PackedDepth(std::string_view file) {
  return file.substr(std::min(kParameters, file.size()));
}

cv::Mat DecodePackedRvl(std::string_view packed) {
  ByteReader reader(packed);
  const auto width = reader.Number<std::uint32_t>(), height = reader.Number<std::uint32_t>();
  CheckRvlSize(width, height);
  cv::Mat depth(static_cast<int>(height), static_cast<int>(width), CV_16UC1);
  if (!client::DecodeRvl(reader.Rest(), depth.ptr<std::uint16_t>(), depth.total())) {
    throw std::invalid_argument(
        fmt::format("an image in RVL is damaged: it is not of {}x{} pixels", width, height));
  }
  return depth;
}

cv::Mat InverseDepthInMeters(std::string_view file, std::string_view codec) {
  ByteReader reader(file);
  reader.Number<std::int32_t>();
  const auto a = reader.Number<float>(), b = reader.Number<float>();
  const cv::Mat inverse =
      codec == "rvl" ? DecodePackedRvl(reader.Rest()) : DecodePackedPng(reader.Rest());
  cv::Mat meters(inverse.size(), CV_32FC1);
  std::transform(
      inverse.begin<std::uint16_t>(), inverse.end<std::uint16_t>(), meters.begin<float>(),
      [&](std::uint16_t value) { return value == 0 ? 0 : a / (static_cast<float>(value) - b); });
  return meters;
}

}  // namespace fovea::cli
