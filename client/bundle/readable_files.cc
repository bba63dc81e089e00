#include "client/bundle/readable_files.h"

#include <zstd.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <opencv2/core.hpp>
#include <vector>

#include "client/image_files/image_files.h"
#include "client/rvl.h"

namespace fovea::bundle {
namespace {

static_assert(std::endian::native == std::endian::little, "depth is taken as it came");

constexpr double kMillimeter = 0.001;
constexpr std::uint64_t kMaxPixels = std::uint64_t{16} << 20;

template <typename Image>
std::size_t PixelsOf(const Image& image) {
  const std::uint64_t pixels = std::uint64_t{image.width()} * image.height();
  return pixels <= kMaxPixels ? static_cast<std::size_t>(pixels) : 0;
}

ImageFile PngOf(const cv::Mat& image) { return {".png", image_files::EncodePng(image)}; }

cv::Mat MatOf(std::uint32_t width, std::uint32_t height, int type, const void* data) {
  return {static_cast<int>(height), static_cast<int>(width), type,
          const_cast<void*>(data)};  // it is only read
}

// At most as many bytes as are wanted, which take memory as they come; empty where there are more,
// or these are no such codes.
std::string Unpacked(const std::string& zstd, std::size_t most) {
  constexpr std::size_t kStep = std::size_t{1} << 20;
  const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context(ZSTD_createDCtx(),
                                                                        ZSTD_freeDCtx);
  ZSTD_inBuffer in{zstd.data(), zstd.size(), 0};
  std::string bytes;
  std::size_t filled = 0, left = 1;
  while (left != 0) {
    bytes.resize(std::min(most + 1, filled + kStep));
    ZSTD_outBuffer out{bytes.data() + filled, bytes.size() - filled, 0};
    left = ZSTD_decompressStream(context.get(), &out, &in);
    filled += out.pos;
    const bool is_stuck = out.pos == 0 && in.pos == in.size;
    if (ZSTD_isError(left) != 0 || filled > most || (left != 0 && is_stuck)) return {};
  }
  bytes.resize(filled);
  return bytes;
}

std::string MillimetersOf(const std::string& meters) {
  std::string result;
  for (std::size_t i = 0; i + sizeof(float) <= meters.size(); i += sizeof(float)) {
    float value = 0;
    std::memcpy(&value, meters.data() + i, sizeof value);
    const double units = std::round(value / kMillimeter);
    const auto unit = static_cast<std::uint16_t>(units > 0 && units <= 65535 ? units : 0);
    result += static_cast<char>(unit & 0xFFU);
    result += static_cast<char>(unit >> 8U);
  }
  return result;
}

// Raw units of 16 bits; empty where there are none of this size.
std::string UnitsOf(const v1::DepthImage& depth, std::size_t pixels) {
  const auto rvl = [&](const std::string& codes) {
    std::vector<std::uint16_t> units(pixels);
    if (!client::DecodeRvl(codes, units.data(), pixels)) return std::string();
    return std::string(reinterpret_cast<const char*>(units.data()), 2 * pixels);
  };
  switch (depth.encoding()) {
    case v1::DEPTH_ENCODING_16UC1:
      return depth.data();
    case v1::DEPTH_ENCODING_16UC1_ZSTD:
      return Unpacked(depth.data(), 2 * pixels);
    case v1::DEPTH_ENCODING_32FC1:
      return MillimetersOf(depth.data());
    case v1::DEPTH_ENCODING_32FC1_ZSTD:
      return MillimetersOf(Unpacked(depth.data(), 4 * pixels));
    case v1::DEPTH_ENCODING_16UC1_RVL:
      return rvl(depth.data());
    case v1::DEPTH_ENCODING_16UC1_RVL_ZSTD:
      return rvl(Unpacked(depth.data(), client::MaxRvlBytes(pixels)));
    default:
      return {};
  }
}

}  // namespace

std::optional<ImageFile> ColorFile(const v1::ColorImage& color) {
  if (color.encoding() == v1::COLOR_ENCODING_JPEG) return ImageFile{".jpg", color.data()};
  if (color.encoding() == v1::COLOR_ENCODING_PNG) return ImageFile{".png", color.data()};
  const std::size_t pixels = PixelsOf(color);
  if (pixels == 0 || color.data().size() != 3 * pixels) return std::nullopt;
  const cv::Mat image = MatOf(color.width(), color.height(), CV_8UC3, color.data().data());
  if (color.encoding() == v1::COLOR_ENCODING_BGR8) return PngOf(image);
  if (color.encoding() != v1::COLOR_ENCODING_RGB8) return std::nullopt;
  cv::Mat swapped(image.size(), CV_8UC3);
  cv::mixChannels(image, swapped, {0, 2, 1, 1, 2, 0});
  return PngOf(swapped);
}

std::optional<ImageFile> DepthFile(const v1::DepthImage& depth) {
  if (depth.encoding() == v1::DEPTH_ENCODING_16UC1_PNG) return ImageFile{".png", depth.data()};
  const std::size_t pixels = PixelsOf(depth);
  const std::string units = pixels > 0 ? UnitsOf(depth, pixels) : "";
  if (units.empty() || units.size() != 2 * pixels) return std::nullopt;
  return PngOf(MatOf(depth.width(), depth.height(), CV_16UC1, units.data()));
}

double UnitOf(const v1::DepthImage& depth) {
  const bool is_metric = depth.encoding() == v1::DEPTH_ENCODING_32FC1 ||
                         depth.encoding() == v1::DEPTH_ENCODING_32FC1_ZSTD;
  return is_metric || depth.unit_m() == 0 ? kMillimeter : depth.unit_m();
}

}  // namespace fovea::bundle
