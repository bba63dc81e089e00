#include "server/codec/png.h"

#include <spng.h>

#include <memory>
#include <new>
#include <stdexcept>
#include <string>

namespace fovea::server {
namespace {

struct Free {
  void operator()(spng_ctx* context) const { spng_ctx_free(context); }
};
using Context = std::unique_ptr<spng_ctx, Free>;

void Require(int error) {
  if (error != 0) {
    throw std::invalid_argument("not a whole PNG: " + std::string(spng_strerror(error)));
  }
}

Context Open(std::string_view file) {
  Context context(spng_ctx_new(0));
  if (!context) throw std::bad_alloc();
  // Text and colour profiles are of no use here: little memory for them.
  constexpr std::size_t kChunkBytes = 1 << 16, kAllChunksBytes = 1 << 18;
  Require(spng_set_chunk_limits(context.get(), kChunkBytes, kAllChunksBytes));
  Require(spng_set_crc_action(context.get(), SPNG_CRC_ERROR, SPNG_CRC_DISCARD));
  Require(spng_set_png_buffer(context.get(), file.data(), file.size()));
  return context;
}

spng_ihdr ReadHeader(const Context& context, const SizeLimits& limits) {
  spng_ihdr header{};
  Require(spng_get_ihdr(context.get(), &header));
  limits.Check(header.width, header.height, "the PNG");
  return header;
}

// "3 channels of 8 bits".
std::string ChannelsOf(const spng_ihdr& header) {
  const std::string bits = " of " + std::to_string(header.bit_depth) + " bits";
  switch (header.color_type) {
    case SPNG_COLOR_TYPE_GRAYSCALE:
      return "one channel" + bits;
    case SPNG_COLOR_TYPE_INDEXED:
      return "a palette" + bits;
    case SPNG_COLOR_TYPE_GRAYSCALE_ALPHA:
      return "2 channels" + bits;
    default:
      return (header.color_type == SPNG_COLOR_TYPE_TRUECOLOR ? "3 channels" : "4 channels") + bits;
  }
}

cv::Mat ReadPixels(const Context& context, const spng_ihdr& header, int type, int format) {
  cv::Mat image(static_cast<int>(header.height), static_cast<int>(header.width), type);
  Require(spng_decode_image(context.get(), image.data, image.total() * image.elemSize(), format,
                            /*flags=*/0));
  // Reads on to the end: a file cut behind its last pixel is not whole either.
  Require(spng_decode_chunks(context.get()));
  return image;
}

}  // namespace

cv::Mat DecodePngColor(std::string_view file, const SizeLimits& limits) {
  const Context context = Open(file);
  const spng_ihdr header = ReadHeader(context, limits);
  if (header.bit_depth > 8) {
    throw std::invalid_argument("the PNG has 16 bits per channel; colour needs 8");
  }
  return ReadPixels(context, header, CV_8UC3, SPNG_FMT_RGB8);
}

cv::Mat DecodePngGray16(std::string_view file, const SizeLimits& limits) {
  const Context context = Open(file);
  const spng_ihdr header = ReadHeader(context, limits);
  if (header.bit_depth != 16 || header.color_type != SPNG_COLOR_TYPE_GRAYSCALE) {
    throw std::invalid_argument("the PNG has " + ChannelsOf(header) +
                                "; depth needs one channel of 16 bits (is this a preview, or the "
                                "colour image?)");
  }
  return ReadPixels(context, header, CV_16UC1, SPNG_FMT_PNG);
}

}  // namespace fovea::server
