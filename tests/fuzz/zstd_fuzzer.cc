#include "server/codec/zstd.h"
#include "tests/fuzz/fuzzing.h"

using namespace fovea;  // NOLINT(google-build-using-namespace): one function

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // The size wanted is part of the input: what a message announces is not to be trusted either.
  if (size < 2) return 0;
  const std::size_t wanted = data[0] | data[1] << 8;
  fuzzing::Try([&] { server::DecompressZstd(fuzzing::Text(data + 2, size - 2), wanted); });
  return 0;
}
