#include "server/codec/jpeg.h"

#include <turbojpeg.h>

#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace fovea::server {
namespace {

struct Destroy {
  void operator()(void* handle) const { tjDestroy(handle); }
};
using Decompressor = std::unique_ptr<std::remove_pointer_t<tjhandle>, Destroy>;

[[noreturn]] void Fail(const Decompressor& decompressor) {
  throw std::invalid_argument("not a whole JPEG: " +
                              std::string(tjGetErrorStr2(decompressor.get())));
}

}  // namespace

cv::Mat DecodeJpeg(std::string_view file, const SizeLimits& limits) {
  const Decompressor decompressor(tjInitDecompress());
  if (!decompressor) throw std::bad_alloc();
  const auto* bytes = reinterpret_cast<const unsigned char*>(file.data());

  int width = 0, height = 0, subsampling = 0, color_space = 0;
  if (tjDecompressHeader3(decompressor.get(), bytes, file.size(), &width, &height, &subsampling,
                          &color_space) != 0) {
    Fail(decompressor);
  }
  if (color_space == TJCS_CMYK || color_space == TJCS_YCCK) {
    throw std::invalid_argument("a JPEG in CMYK, which is not read: save it in RGB");
  }
  limits.Check(static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height), "the JPEG");

  cv::Mat image(height, width, CV_8UC3);
  // By default libjpeg only warns about missing data and paints the rest grey. The scan limit
  // bounds the work that a small progressive file can ask for.
  constexpr int kFlags = TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS | TJFLAG_ACCURATEDCT;
  if (tjDecompress2(decompressor.get(), bytes, file.size(), image.data, width, /*pitch=*/0, height,
                    TJPF_RGB, kFlags) != 0) {
    Fail(decompressor);
  }
  return image;
}

}  // namespace fovea::server
