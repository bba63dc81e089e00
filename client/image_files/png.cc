#include "client/image_files/png.h"

#include <spng.h>

#include <cstdlib>
#include <memory>
#include <new>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>

#include "client/image_files/image_files.h"
#include "client/image_files/limits.h"

namespace fovea::image_files {
namespace {

using Context = std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)>;

void Require(int error) {
  if (error != 0) {
    throw std::runtime_error(std::string("it is not a whole PNG: ") + spng_strerror(error));
  }
}

Context NewContext(int flags) {
  Context context(spng_ctx_new(flags), spng_ctx_free);
  if (!context) throw std::bad_alloc();
  return context;
}

class Reader {
 public:
  explicit Reader(std::string_view file) : context_(NewContext(0)) {
    constexpr std::size_t kChunkBytes = 1 << 20,
                          kAllChunksBytes = 1 << 22;  // of texts and profiles
    Require(spng_set_chunk_limits(context_.get(), kChunkBytes, kAllChunksBytes));
    Require(spng_set_png_buffer(context_.get(), file.data(), file.size()));
    Require(spng_get_ihdr(context_.get(), &header_));
    CheckSize(header_.width, header_.height);
  }

  const spng_ihdr& Header() const { return header_; }

  cv::Mat Pixels(int type, int format) {
    cv::Mat image(static_cast<int>(header_.height), static_cast<int>(header_.width), type);
    Require(spng_decode_image(context_.get(), image.data, image.total() * image.elemSize(), format,
                              /*flags=*/0));
    return image;
  }

 private:
  Context context_;
  spng_ihdr header_{};
};

// Red and blue exchanged.
cv::Mat Exchanged(const cv::Mat& image) {
  cv::Mat exchanged(image.size(), image.type());
  if (image.channels() == 3) cv::mixChannels(image, exchanged, {0, 2, 1, 1, 2, 0});
  if (image.channels() == 4) cv::mixChannels(image, exchanged, {0, 2, 1, 1, 2, 0, 3, 3});
  return exchanged;
}

spng_color_type ColorTypeOf(const cv::Mat& image) {
  switch (image.channels()) {
    case 1:
      return SPNG_COLOR_TYPE_GRAYSCALE;
    case 3:
      return SPNG_COLOR_TYPE_TRUECOLOR;
    case 4:
      return SPNG_COLOR_TYPE_TRUECOLOR_ALPHA;
    default:
      throw std::runtime_error("no PNG has so many channels");
  }
}

}  // namespace

bool IsPng(std::string_view file) { return file.substr(0, 4) == "\x89PNG"; }

cv::Mat DecodePngColor(std::string_view file) {
  return Exchanged(Reader(file).Pixels(CV_8UC3, SPNG_FMT_RGB8));
}

cv::Mat DecodeDepth(std::string_view file) {
  if (!IsPng(file)) throw std::runtime_error("it is not a PNG");
  Reader reader(file);
  const spng_ihdr& header = reader.Header();
  if (header.bit_depth != 16 || header.color_type != SPNG_COLOR_TYPE_GRAYSCALE) {
    throw std::runtime_error("it has not one channel of 16 bits");
  }
  return reader.Pixels(CV_16UC1, SPNG_FMT_PNG);
}

std::string EncodePng(const cv::Mat& image) {
  const cv::Mat pixels = image.channels() > 1   ? Exchanged(image)
                         : image.isContinuous() ? image
                                                : image.clone();
  const Context context = NewContext(SPNG_CTX_ENCODER);
  Require(spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1));
  Require(spng_set_option(context.get(), SPNG_IMG_COMPRESSION_LEVEL, 1));
  Require(spng_set_option(context.get(), SPNG_FILTER_CHOICE, SPNG_FILTER_CHOICE_SUB));
  spng_ihdr header{};
  header.width = static_cast<std::uint32_t>(pixels.cols);
  header.height = static_cast<std::uint32_t>(pixels.rows);
  header.bit_depth = pixels.depth() == CV_16U ? 16 : 8;
  header.color_type = ColorTypeOf(pixels);
  Require(spng_set_ihdr(context.get(), &header));
  Require(spng_encode_image(context.get(), pixels.data, pixels.total() * pixels.elemSize(),
                            SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE));
  std::size_t size = 0;
  int error = 0;
  const std::unique_ptr<void, decltype(&std::free)> file(
      spng_get_png_buffer(context.get(), &size, &error), std::free);
  Require(error);
  return {static_cast<const char*>(file.get()), size};
}

}  // namespace fovea::image_files
