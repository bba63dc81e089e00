#include "client/image_files/jpeg.h"

#include <turbojpeg.h>

#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "client/image_files/image_files.h"
#include "client/image_files/limits.h"
#include "client/image_files/png.h"

namespace fovea::image_files {
namespace {

struct Destroy {
  void operator()(void* handle) const { tjDestroy(handle); }
};
using Handle = std::unique_ptr<std::remove_pointer_t<tjhandle>, Destroy>;

Handle Opened(tjhandle handle) {
  if (handle == nullptr) throw std::bad_alloc();
  return Handle(handle);
}

}  // namespace

cv::Mat DecodeJpeg(std::string_view file) {
  const Handle handle = Opened(tjInitDecompress());
  const auto require = [&](int error) {
    if (error == 0) return;
    throw std::runtime_error(std::string("it is neither a PNG nor a whole JPEG: ") +
                             tjGetErrorStr2(handle.get()));
  };
  const auto* bytes = reinterpret_cast<const unsigned char*>(file.data());
  int width = 0, height = 0, subsampling = 0, color_space = 0;
  require(tjDecompressHeader3(handle.get(), bytes, file.size(), &width, &height, &subsampling,
                              &color_space));
  if (color_space == TJCS_CMYK || color_space == TJCS_YCCK) {
    throw std::runtime_error("it is a JPEG in CMYK: save it in RGB");
  }
  CheckSize(static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height));
  cv::Mat image(height, width, CV_8UC3);
  // By default libjpeg only warns about missing data and paints the rest grey.
  constexpr int kFlags = TJFLAG_STOPONWARNING | TJFLAG_ACCURATEDCT;
  require(tjDecompress2(handle.get(), bytes, file.size(), image.data, width, /*pitch=*/0, height,
                        TJPF_BGR, kFlags));
  return image;
}

cv::Mat DecodeColor(std::string_view file) {
  return IsPng(file) ? DecodePngColor(file) : DecodeJpeg(file);
}

std::string EncodeJpeg(const cv::Mat& image, int quality) {
  const Handle handle = Opened(tjInitCompress());
  const bool is_gray = image.channels() == 1;
  unsigned char* file = nullptr;
  unsigned long size = 0;
  const int error = tjCompress2(handle.get(), image.data, image.cols, static_cast<int>(image.step),
                                image.rows, is_gray ? TJPF_GRAY : TJPF_BGR, &file, &size,
                                is_gray ? TJSAMP_GRAY : TJSAMP_420, quality, TJFLAG_ACCURATEDCT);
  const std::unique_ptr<unsigned char, void (*)(unsigned char*)> owner(file, tjFree);
  if (error != 0) {
    throw std::runtime_error(std::string("no JPEG of it: ") + tjGetErrorStr2(handle.get()));
  }
  return {reinterpret_cast<const char*>(file), size};
}

}  // namespace fovea::image_files
