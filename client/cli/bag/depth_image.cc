#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <opencv2/core.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "client/cli/bag/compressed_depth.h"
#include "client/cli/bag/image_message.h"
#include "client/cli/bag/ros_images.h"
#include "client/image_files/image_files.h"

namespace fovea::cli {
namespace {

constexpr const char* kDepth = "depth that is read (16UC1, mono16, 32FC1)";
constexpr const char* kDepthFile =
    "depth that is read (PNG, compressedDepth in PNG or RVL of 16UC1, mono16 or 32FC1)";
constexpr std::string_view kPngBegin("\x89PNG\r\n\x1a\n", 8);

bool IsInUnits(std::string_view encoding) { return encoding == "16UC1" || encoding == "mono16"; }
bool IsInMeters(std::string_view encoding) { return encoding == "32FC1"; }

cv::Mat UnitsOf(const cv::Mat& meters, double unit_m) {
  constexpr double kMostUnits = std::numeric_limits<std::uint16_t>::max();
  cv::Mat units(meters.size(), CV_16UC1);
  double nearest_m = std::numeric_limits<double>::infinity();
  for (int y = 0; y < meters.rows; ++y) {
    for (int x = 0; x < meters.cols; ++x) {
      const double depth_m = meters.at<float>(y, x);
      const double unit = std::round(depth_m / unit_m);
      units.at<std::uint16_t>(y, x) =
          unit > 0 && unit <= kMostUnits ? static_cast<std::uint16_t>(unit) : 0;
      if (depth_m > 0) nearest_m = std::min(nearest_m, depth_m);
    }
  }
  // Millimetres, most likely, which nobody would see in an image without depth.
  if (std::isfinite(nearest_m) && std::round(nearest_m / unit_m) > kMostUnits) {
    throw std::invalid_argument(
        fmt::format("the nearest depth of an image of 32FC1, which is in metres, is {:g} m, and 16 "
                    "bits hold {:g} m: check its unit",
                    nearest_m, kMostUnits * unit_m));
  }
  return units;
}

// Nothing where it is no such file.
std::optional<std::string> FromCompressedDepth(const CompressedImageMessage& image, double unit_m) {
  const std::optional<DepthFormat> format = ParseDepthFormat(image.format);
  if (!format) return std::nullopt;
  const std::string_view packed = PackedDepth(image.data);
  const bool is_png = format->codec == "png" && packed.starts_with(kPngBegin);
  if (!is_png && format->codec != "rvl") return std::nullopt;
  if (IsInMeters(format->encoding)) {
    return image_files::EncodePng(UnitsOf(InverseDepthInMeters(image.data, format->codec), unit_m));
  }
  if (!IsInUnits(format->encoding)) return std::nullopt;
  return is_png ? std::string(packed) : image_files::EncodePng(DecodePackedRvl(packed));
}

std::string FileOf(const CompressedImageMessage& image, double unit_m) {
  if (std::optional<std::string> file = FromCompressedDepth(image, unit_m)) return *std::move(file);
  if (image.data.starts_with(kPngBegin)) return std::string(image.data);
  throw NoUse(kDepthFile, image.format);
}

}  // namespace

std::string DepthFile(std::string_view message, bool compressed, double unit_m) {
  if (compressed) return FileOf(ReadCompressedImage(message), unit_m);
  const ImageMessage image = ReadImage(message);
  if (image.big_endian) throw std::invalid_argument("depth is big-endian");
  if (IsInUnits(image.encoding)) return image_files::EncodePng(PixelsOf(image, CV_16UC1));
  if (IsInMeters(image.encoding)) {
    return image_files::EncodePng(UnitsOf(PixelsOf(image, CV_32FC1), unit_m));
  }
  throw NoUse(kDepth, image.encoding);
}

}  // namespace fovea::cli
