#include "client/cli/bag/decompression.h"

#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

namespace fovea::cli {
namespace {

constexpr std::uint64_t kMost = std::uint64_t{256} << 20;
constexpr std::size_t kStep = std::size_t{1} << 20;

// Grows as bytes come, since the size that a file states may be a lie.
class Growing {
 public:
  explicit Growing(std::uint64_t size) : size_(static_cast<std::size_t>(size)) {}

  // Room for the next bytes; none left where all of `size` are there.
  std::size_t Room() {
    result_.resize(std::min(size_, filled_ + kStep));
    return result_.size() - filled_;
  }
  char* end() { return result_.data() + filled_; }
  void Filled(std::size_t count) { filled_ += count; }
  bool IsFull() const { return filled_ == size_; }

  std::string Take() {
    if (!IsFull()) throw std::invalid_argument("a chunk holds less than it says");
    return std::move(result_);
  }

 private:
  const std::size_t size_;
  std::string result_;
  std::size_t filled_ = 0;
};

std::string FromZstd(std::string_view bytes, std::uint64_t size) {
  struct Free {
    void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
  };
  const std::unique_ptr<ZSTD_DCtx, Free> context(ZSTD_createDCtx());
  Growing result(size);
  ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
  while (!result.IsFull()) {
    const std::size_t room = result.Room();
    ZSTD_outBuffer out{result.end(), room, 0};
    const std::size_t left = ZSTD_decompressStream(context.get(), &out, &in);
    if (ZSTD_isError(left) != 0) {
      throw std::invalid_argument(std::string("zstd: ") + ZSTD_getErrorName(left));
    }
    result.Filled(out.pos);
    if (out.pos == 0 && in.pos == in.size) break;
  }
  return result.Take();
}

std::string FromLz4(std::string_view bytes, std::uint64_t size) {
  LZ4F_dctx* made = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION)) != 0) {
    throw std::bad_alloc();
  }
  struct Free {
    void operator()(LZ4F_dctx* context) const { LZ4F_freeDecompressionContext(context); }
  };
  const std::unique_ptr<LZ4F_dctx, Free> context(made);
  Growing result(size);
  while (!result.IsFull()) {
    std::size_t written = result.Room(), read = bytes.size();
    const std::size_t left =
        LZ4F_decompress(context.get(), result.end(), &written, bytes.data(), &read, nullptr);
    if (LZ4F_isError(left) != 0) {
      throw std::invalid_argument(std::string("lz4: ") + LZ4F_getErrorName(left));
    }
    result.Filled(written);
    bytes.remove_prefix(read);
    if (written == 0 && (read == 0 || bytes.empty())) break;
  }
  return result.Take();
}

}  // namespace

std::string Decompress(std::string_view bytes, std::string_view compression, std::uint64_t size) {
  if (size > kMost) throw std::invalid_argument("a chunk is larger than 256 MiB");
  if (compression == "zstd") return FromZstd(bytes, size);
  if (compression == "lz4") return FromLz4(bytes, size);
  if (!compression.empty()) throw std::invalid_argument("a chunk is neither zstd nor lz4");
  if (bytes.size() != size) throw std::invalid_argument("a chunk's size is not what it says");
  return std::string(bytes);
}

}  // namespace fovea::cli
