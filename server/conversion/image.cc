#include "server/conversion/image.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>

#include "server/codec/jpeg.h"
#include "server/codec/png.h"
#include "server/codec/raw.h"
#include "server/codec/rvl.h"
#include "server/codec/size_limits.h"
#include "server/codec/zstd.h"
#include "server/conversion/field_error.h"

namespace fovea::server {
namespace {

const std::string kColor = "frame.color", kDepth = "frame.depth";

// For images whose size nothing but the message tells.
void RequireSize(const std::string& path, std::uint32_t width, std::uint32_t height,
                 std::uint64_t max_pixels) {
  RequireField(width > 0, path + ".width", "must be positive");
  RequireField(height > 0, path + ".height", "must be positive");
  InField(path + ".width, height",
          [&] { SizeLimits{.max_pixels = max_pixels}.Check(width, height, "the image"); });
}

cv::Mat RowsOf(const std::string& path, std::string_view bytes, std::uint32_t width,
               std::uint32_t height, int type, const char* kind) {
  return InField(path + ".data", [&] {
    return ImageFromRows(bytes, static_cast<int>(width), static_cast<int>(height), type, kind);
  });
}

template <typename Image>
SizeLimits LimitsOf(const Image& image, std::uint64_t max_pixels) {
  return {.width = image.width(), .height = image.height(), .max_pixels = max_pixels};
}

cv::Mat RawColor(const v1::ColorImage& color, std::uint64_t max_pixels, const char* kind) {
  RequireSize(kColor, color.width(), color.height(), max_pixels);
  return RowsOf(kColor, color.data(), color.width(), color.height(), CV_8UC3, kind);
}

cv::Mat RawDepth(const v1::DepthImage& depth, std::uint64_t max_pixels, int type,
                 const char* kind) {
  RequireSize(kDepth, depth.width(), depth.height(), max_pixels);
  return RowsOf(kDepth, depth.data(), depth.width(), depth.height(), type, kind);
}

cv::Mat ZstdDepth(const v1::DepthImage& depth, std::uint64_t max_pixels, int type,
                  const char* kind) {
  RequireSize(kDepth, depth.width(), depth.height(), max_pixels);
  const std::uint64_t num_bytes =
      std::uint64_t{depth.width()} * depth.height() * CV_ELEM_SIZE(type);
  const std::string bytes =
      InField(kDepth + ".data", [&] { return DecompressZstd(depth.data(), num_bytes); });
  return RowsOf(kDepth, bytes, depth.width(), depth.height(), type, kind);
}

cv::Mat RvlDepth(const v1::DepthImage& depth, std::uint64_t max_pixels, bool is_packed) {
  RequireSize(kDepth, depth.width(), depth.height(), max_pixels);
  return InField(kDepth + ".data", [&] {
    const auto width = static_cast<int>(depth.width()), height = static_cast<int>(depth.height());
    if (!is_packed) return DecodeRvl(depth.data(), width, height);
    const std::size_t max_bytes = MaxRvlBytes(std::size_t{depth.width()} * depth.height());
    return DecodeRvl(DecompressZstdUpTo(depth.data(), max_bytes), width, height);
  });
}

double UnitOf(const v1::DepthImage& depth) {
  const double unit_m = depth.unit_m();
  RequireField(std::isfinite(unit_m) && unit_m >= 0 && unit_m <= 1, kDepth + ".unit_m",
               std::to_string(unit_m) + " is not between 0 (for 0.001) and 1 metre");
  return unit_m == 0 ? 0.001 : unit_m;
}

}  // namespace

cv::Mat ColorFromProto(const v1::ColorImage& color, std::uint64_t max_pixels) {
  switch (color.encoding()) {
    case v1::COLOR_ENCODING_RGB8:
      return RawColor(color, max_pixels, "RGB8");
    case v1::COLOR_ENCODING_BGR8: {
      cv::Mat rgb;
      cv::cvtColor(RawColor(color, max_pixels, "BGR8"), rgb, cv::COLOR_BGR2RGB);
      return rgb;
    }
    case v1::COLOR_ENCODING_JPEG:
      return InField(kColor + ".data",
                     [&] { return DecodeJpeg(color.data(), LimitsOf(color, max_pixels)); });
    case v1::COLOR_ENCODING_PNG:
      return InField(kColor + ".data",
                     [&] { return DecodePngColor(color.data(), LimitsOf(color, max_pixels)); });
    default:
      FailField(kColor + ".encoding",
                std::to_string(color.encoding()) + " is not one of RGB8, BGR8, JPEG, PNG");
  }
}

cv::Mat DepthFromProto(const v1::DepthImage& depth, std::uint64_t max_pixels) {
  const double unit_m = UnitOf(depth);
  switch (depth.encoding()) {
    case v1::DEPTH_ENCODING_16UC1:
      return MetersFrom16U(RawDepth(depth, max_pixels, CV_16UC1, "16UC1"), unit_m);
    case v1::DEPTH_ENCODING_32FC1:
      return MetersFrom32F(RawDepth(depth, max_pixels, CV_32FC1, "32FC1"));
    case v1::DEPTH_ENCODING_16UC1_PNG:
      return MetersFrom16U(
          InField(kDepth + ".data",
                  [&] { return DecodePngGray16(depth.data(), LimitsOf(depth, max_pixels)); }),
          unit_m);
    case v1::DEPTH_ENCODING_16UC1_ZSTD:
      return MetersFrom16U(ZstdDepth(depth, max_pixels, CV_16UC1, "16UC1"), unit_m);
    case v1::DEPTH_ENCODING_32FC1_ZSTD:
      return MetersFrom32F(ZstdDepth(depth, max_pixels, CV_32FC1, "32FC1"));
    case v1::DEPTH_ENCODING_16UC1_RVL:
      return MetersFrom16U(RvlDepth(depth, max_pixels, /*is_packed=*/false), unit_m);
    case v1::DEPTH_ENCODING_16UC1_RVL_ZSTD:
      return MetersFrom16U(RvlDepth(depth, max_pixels, /*is_packed=*/true), unit_m);
    default:
      FailField(kDepth + ".encoding", std::to_string(depth.encoding()) +
                                          " is not one of 16UC1, 32FC1, 16UC1_PNG, 16UC1_ZSTD, "
                                          "32FC1_ZSTD, 16UC1_RVL, 16UC1_RVL_ZSTD");
  }
}

}  // namespace fovea::server
