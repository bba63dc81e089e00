#include "server/codec/rvl.h"
#include "tests/fuzz/fuzzing.h"

using namespace fovea;  // NOLINT(google-build-using-namespace): one function

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzzing::Try([&] { server::DecodeRvl(fuzzing::Text(data, size), 32, 24); });
  return 0;
}
