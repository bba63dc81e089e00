// The decoders of images and depth, those of the programs beside the client library too.
#include "client/image_files/image_files.h"
#include "server/codec/jpeg.h"
#include "server/codec/png.h"
#include "server/codec/rvl.h"
#include "server/codec/zstd.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/fuzzing.h"

namespace fovea::fuzzing {
namespace {

// Bad files must end in std::runtime_error there.
template <typename Function>
void TryFile(Function&& function) {
  try {
    function();
  } catch (const std::runtime_error&) {  // NOLINT(bugprone-empty-catch): the refusal wanted
  }
}

}  // namespace

void FuzzJpeg(const std::uint8_t* data, std::size_t size) {
  Try([&] { server::DecodeJpeg(Text(data, size), {.max_pixels = kMaxPixels}); });
  TryFile([&] { image_files::DecodeColor(Text(data, size)); });
}

void FuzzPng(const std::uint8_t* data, std::size_t size) {
  const server::SizeLimits limits{.max_pixels = kMaxPixels};
  Try([&] { server::DecodePngColor(Text(data, size), limits); });
  Try([&] { server::DecodePngGray16(Text(data, size), limits); });
  TryFile([&] { image_files::DecodeColor(Text(data, size)); });
  TryFile([&] { image_files::DecodeDepth(Text(data, size)); });
}

void FuzzRvl(const std::uint8_t* data, std::size_t size) {
  Try([&] { server::DecodeRvl(Text(data, size), 32, 24); });
}

// The size wanted is part of the input: what a message announces is not to be trusted either.
void FuzzZstd(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return;
  const std::size_t wanted = data[0] | data[1] << 8;
  Try([&] { server::DecompressZstd(Text(data + 2, size - 2), wanted); });
}

}  // namespace fovea::fuzzing
