#include "server/codec/jpeg.h"
#include "tests/fuzz/fuzzing.h"

using namespace fovea;  // NOLINT(google-build-using-namespace): one function

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzzing::Try(
      [&] { server::DecodeJpeg(fuzzing::Text(data, size), {.max_pixels = fuzzing::kMaxPixels}); });
  return 0;
}
