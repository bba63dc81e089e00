#include "server/codec/zstd.h"

#include <zstd.h>

#include <stdexcept>

namespace fovea::server {
namespace {

void Require(bool holds, const std::string& message) {
  if (!holds) throw std::invalid_argument(message);
}

// Of the one whole frame that the data are; ZSTD_CONTENTSIZE_UNKNOWN where it does not say.
unsigned long long ClaimedBytes(std::string_view data) {
  const std::size_t frame_bytes = ZSTD_findFrameCompressedSize(data.data(), data.size());
  Require(!ZSTD_isError(frame_bytes), "not a whole zstd frame");
  Require(frame_bytes == data.size(),
          "has " + std::to_string(data.size() - frame_bytes) + " bytes behind the zstd frame");
  return ZSTD_getFrameContentSize(data.data(), data.size());
}

}  // namespace

std::string DecompressZstd(std::string_view data, std::size_t num_bytes) {
  const unsigned long long claimed = ClaimedBytes(data);
  Require(claimed == ZSTD_CONTENTSIZE_UNKNOWN || claimed == num_bytes,
          "the zstd frame holds " + std::to_string(claimed) + " bytes, needed are " +
              std::to_string(num_bytes));

  // Straight into the result: no window is allocated, however large the frame's header wants it.
  std::string result(num_bytes, '\0');
  const std::size_t written =
      ZSTD_decompress(result.data(), result.size(), data.data(), data.size());
  Require(!ZSTD_isError(written),
          "the zstd frame does not decompress: " + std::string(ZSTD_getErrorName(written)));
  Require(written == num_bytes, "the zstd frame holds " + std::to_string(written) +
                                    " bytes, needed are " + std::to_string(num_bytes));
  return result;
}

std::string DecompressZstdUpTo(std::string_view data, std::size_t max_bytes) {
  const unsigned long long claimed = ClaimedBytes(data);
  Require(claimed != ZSTD_CONTENTSIZE_UNKNOWN,
          "the zstd frame does not say how many bytes it holds");
  Require(claimed <= max_bytes, "the zstd frame holds " + std::to_string(claimed) +
                                    " bytes, needed are at most " + std::to_string(max_bytes));
  return DecompressZstd(data, static_cast<std::size_t>(claimed));
}

}  // namespace fovea::server
