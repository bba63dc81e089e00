#include "server/observing/pictures.h"

#include <turbojpeg.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <vector>

#include "core/depth/measured_depth.h"
#include "server/conversion/image.h"

namespace fovea::server {
namespace {

constexpr int kPictureQuality = 85, kPreviewQuality = 70, kPreviewSide = 320;

std::string Gzip(const void* data, std::size_t num_bytes) {
  constexpr int kGzipWindow = 15 + 16, kMemory = 9, kFastest = 1;
  z_stream stream{};
  if (deflateInit2(&stream, kFastest, Z_DEFLATED, kGzipWindow, kMemory, Z_DEFAULT_STRATEGY) !=
      Z_OK) {
    throw std::runtime_error("zlib cannot start");
  }
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&stream, deflateEnd);
  std::string compressed(deflateBound(&stream, num_bytes), '\0');
  // zlib reads it only, but for a macro of its own has no const.
  stream.next_in = static_cast<Bytef*>(const_cast<void*>(data));
  stream.avail_in = static_cast<uInt>(num_bytes);
  stream.next_out = reinterpret_cast<Bytef*>(compressed.data());
  stream.avail_out = static_cast<uInt>(compressed.size());
  if (deflate(&stream, Z_FINISH) != Z_STREAM_END) throw std::runtime_error("zlib failed");
  compressed.resize(stream.total_out);
  return compressed;
}

// What is farther, which max_depth_m cannot be, would leave the rest without its millimetres.
constexpr double kFarthestShown_m = 100;

double UnitOf(const cv::Mat& shown_m) {
  constexpr double kMillimeter = 0.001;
  float farthest = 0;
  for (auto pixel = shown_m.begin<float>(); pixel != shown_m.end<float>(); ++pixel) {
    if (!std::isnan(*pixel)) farthest = std::max(farthest, *pixel);
  }
  return std::max(kMillimeter,
                  static_cast<double>(farthest) / std::numeric_limits<std::uint16_t>::max());
}

}  // namespace

std::string JpegOf(const cv::Mat& color_rgb, int quality) {
  const std::unique_ptr<void, int (*)(tjhandle)> encoder(tjInitCompress(), tjDestroy);
  unsigned char* file = nullptr;
  unsigned long size = 0;
  const int failed =
      tjCompress2(encoder.get(), color_rgb.data, color_rgb.cols, static_cast<int>(color_rgb.step),
                  color_rgb.rows, TJPF_RGB, &file, &size, TJSAMP_420, quality, TJFLAG_FASTDCT);
  const std::unique_ptr<unsigned char, void (*)(unsigned char*)> owner(file, tjFree);
  if (failed != 0) throw std::runtime_error(std::string("turbojpeg: ") + tjGetErrorStr());
  return {reinterpret_cast<const char*>(file), size};
}

std::string PictureOf(const v1::ColorImage& color, std::uint64_t max_pixels) {
  if (color.encoding() == v1::COLOR_ENCODING_JPEG) return color.data();
  return JpegOf(ColorFromProto(color, max_pixels), kPictureQuality);
}

std::string PreviewOf(const v1::ColorImage& color, std::uint64_t max_pixels) {
  cv::Mat picture = ColorFromProto(color, max_pixels);
  const double scale =
      std::min(1.0, static_cast<double>(kPreviewSide) / std::max(picture.cols, picture.rows));
  if (scale < 1) {
    const cv::Size size(std::max(1, static_cast<int>(std::lround(picture.cols * scale))),
                        std::max(1, static_cast<int>(std::lround(picture.rows * scale))));
    cv::resize(picture, picture, size, 0, 0, cv::INTER_AREA);
  }
  return JpegOf(picture, kPreviewQuality);
}

v1::WatchedDepth DepthOf(const RgbdFrame& decoded) {
  const cv::Mat depth_m = DepthUpTo(MeasuredDepth(decoded.depth_m), kFarthestShown_m);
  v1::WatchedDepth depth;
  depth.set_width(static_cast<std::uint32_t>(depth_m.cols));
  depth.set_height(static_cast<std::uint32_t>(depth_m.rows));
  depth.set_unit_m(UnitOf(depth_m));
  std::vector<std::uint16_t> units;
  units.reserve(depth_m.total());
  for (auto pixel = depth_m.begin<float>(); pixel != depth_m.end<float>(); ++pixel) {
    const bool measured = !std::isnan(*pixel);
    units.push_back(measured ? static_cast<std::uint16_t>(std::lround(*pixel / depth.unit_m()))
                             : std::uint16_t{0});
  }
  depth.set_data(Gzip(units.data(), units.size() * sizeof(units.front())));
  depth.mutable_intrinsics()->set_fx(decoded.intrinsics.fx_px);
  depth.mutable_intrinsics()->set_fy(decoded.intrinsics.fy_px);
  depth.mutable_intrinsics()->set_cx(decoded.intrinsics.cx_px);
  depth.mutable_intrinsics()->set_cy(decoded.intrinsics.cy_px);
  return depth;
}

}  // namespace fovea::server
