#include "client/capture/encoding.h"

#include <google/protobuf/util/time_util.h>
#include <turbojpeg.h>
#include <zstd.h>

#include <cstdio>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "client/images.h"

namespace fovea::capture {
namespace {

google::protobuf::Timestamp TimestampOf(std::chrono::system_clock::time_point time) {
  using std::chrono::nanoseconds;
  return google::protobuf::util::TimeUtil::NanosecondsToTimestamp(
      std::chrono::duration_cast<nanoseconds>(time.time_since_epoch()).count());
}

}  // namespace

struct Encoder::Codecs {
  struct Destroy {
    void operator()(void* handle) const { tjDestroy(handle); }
    void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
    void operator()(unsigned char* buffer) const { tjFree(buffer); }
  };

  std::unique_ptr<std::remove_pointer_t<tjhandle>, Destroy> jpeg{tjInitCompress()};
  std::unique_ptr<ZSTD_CCtx, Destroy> zstd{ZSTD_createCCtx()};
};

v1::ColorEncoding ParseColorEncoding(const std::string& name) {
  if (name == "jpeg") return v1::COLOR_ENCODING_JPEG;
  if (name == "rgb8") return v1::COLOR_ENCODING_RGB8;
  throw std::invalid_argument("--color-encoding: \"" + name + "\" is not jpeg or rgb8");
}

Encoder::Encoder(const EncodingOptions& options)
    : options_(options), codecs_(std::make_unique<Codecs>()) {}

Encoder::~Encoder() = default;

v1::Frame Encoder::Encode(const Picture& picture) {
  v1::Frame frame;
  frame.set_id(FrameName(picture.number));
  *frame.mutable_captured_at() = TimestampOf(picture.captured_at);
  *frame.mutable_color() = EncodeColor(picture.color);
  *frame.mutable_depth() = EncodeDepth(picture.depth, picture.depth_unit_m);
  return frame;
}

v1::ColorImage Encoder::EncodeColor(const cv::Mat& color) {
  if (options_.color == v1::COLOR_ENCODING_RGB8) {
    return client::MakeColorImage(color.data, static_cast<std::uint32_t>(color.cols),
                                  static_cast<std::uint32_t>(color.rows), options_.color);
  }
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  const int failed =
      tjCompress2(codecs_->jpeg.get(), color.data, color.cols, static_cast<int>(color.step),
                  color.rows, TJPF_RGB, &bytes, &size, TJSAMP_420, options_.jpeg_quality, 0);
  const std::unique_ptr<unsigned char, Codecs::Destroy> owner(bytes);
  if (failed != 0) {
    throw std::runtime_error(std::string("JPEG: ") + tjGetErrorStr2(codecs_->jpeg.get()));
  }
  return client::MakeColorImage(std::string(reinterpret_cast<const char*>(bytes), size));
}

v1::DepthImage Encoder::EncodeDepth(const cv::Mat& depth, double unit_m) {
  constexpr int kFastest = 1;
  v1::DepthImage image =
      client::MakeRvlDepthImage(depth.ptr<std::uint16_t>(), static_cast<std::uint32_t>(depth.cols),
                                static_cast<std::uint32_t>(depth.rows), unit_m);
  const std::string& codes = image.data();
  std::string packed(ZSTD_compressBound(codes.size()), '\0');
  const std::size_t size = ZSTD_compressCCtx(codecs_->zstd.get(), packed.data(), packed.size(),
                                             codes.data(), codes.size(), kFastest);
  if (ZSTD_isError(size) != 0) {
    throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(size));
  }
  packed.resize(size);
  image.set_encoding(v1::DEPTH_ENCODING_16UC1_RVL_ZSTD);
  image.set_data(std::move(packed));
  return image;
}

std::string FrameName(std::uint64_t number) {
  char name[24];
  std::snprintf(name, sizeof name, "%06llu", static_cast<unsigned long long>(number));
  return name;
}

}  // namespace fovea::capture
