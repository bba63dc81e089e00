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

// Progressive files come in scans, mostly some ten, and each goes over the whole image however few
// bytes it has: of hundreds, nobody can stop the decoder in time.
void CheckScans(std::string_view file) {
  constexpr int kMaxScans = 64;
  constexpr std::string_view kStartOfScan = "\xFF\xDA";  // in what is coded it does not occur
  int num_scans = 0;
  for (auto at = file.find(kStartOfScan); at != file.npos; at = file.find(kStartOfScan, at + 2)) {
    if (++num_scans > kMaxScans) throw std::invalid_argument("a JPEG of more than 64 scans");
  }
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
  CheckScans(file);
  // By default libjpeg only warns about missing data and paints the rest grey.
  constexpr int kFlags = TJFLAG_STOPONWARNING | TJFLAG_ACCURATEDCT;
  if (tjDecompress2(decompressor.get(), bytes, file.size(), image.data, width, /*pitch=*/0, height,
                    TJPF_RGB, kFlags) != 0) {
    Fail(decompressor);
  }
  return image;
}

}  // namespace fovea::server
