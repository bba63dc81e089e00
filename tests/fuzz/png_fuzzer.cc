#include "server/codec/png.h"
#include "tests/fuzz/fuzzing.h"

using namespace fovea;  // NOLINT(google-build-using-namespace): one function

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const server::SizeLimits limits{.max_pixels = fuzzing::kMaxPixels};
  fuzzing::Try([&] { server::DecodePngColor(fuzzing::Text(data, size), limits); });
  fuzzing::Try([&] { server::DecodePngGray16(fuzzing::Text(data, size), limits); });
  return 0;
}
