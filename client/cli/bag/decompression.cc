#include "client/cli/bag/decompression.h"

#include <lz4frame.h>
#include <zstd.h>

#include <new>
#include <stdexcept>

#include "client/cli/bag/growing_bytes.h"

namespace fovea::cli {
namespace {

constexpr std::uint64_t kMost = std::uint64_t{256} << 20;
constexpr std::string_view kZstdBegin("\x28\xB5\x2F\xFD", 4);  // no CDR begins so

}  // namespace

class Decompressor::Contexts {
 public:
  GrowingBytes result;

  // Until `most` bytes are there or none are left. Whether it ended with a frame.
  bool Zstd(std::string_view bytes, std::uint64_t most) {
    if (!zstd_) zstd_.reset(ZSTD_createDCtx());
    if (!zstd_) throw std::bad_alloc();
    ZSTD_DCtx_reset(zstd_.get(), ZSTD_reset_session_only);
    result.Clear(most);
    ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
    std::size_t left = 1;
    while (!result.IsFull()) {
      const std::size_t room = result.Room();
      ZSTD_outBuffer out{result.end(), room, 0};
      const std::size_t read_before = in.pos;
      const std::size_t expected = ZSTD_decompressStream(zstd_.get(), &out, &in);
      if (ZSTD_isError(expected) != 0) {
        throw std::invalid_argument(std::string("zstd: ") + ZSTD_getErrorName(expected));
      }
      result.Filled(out.pos);
      if (out.pos == 0 && in.pos == read_before) break;  // at the end of its bytes
      left = expected;
    }
    return left == 0;
  }

  void Lz4(std::string_view bytes, std::uint64_t most) {
    LZ4F_dctx* const context = Lz4Context();
    result.Clear(most);
    while (!result.IsFull()) {
      std::size_t written = result.Room(), read = bytes.size();
      const std::size_t left =
          LZ4F_decompress(context, result.end(), &written, bytes.data(), &read, nullptr);
      if (LZ4F_isError(left) != 0) {
        throw std::invalid_argument(std::string("lz4: ") + LZ4F_getErrorName(left));
      }
      result.Filled(written);
      bytes.remove_prefix(read);
      if (written == 0 && (read == 0 || bytes.empty())) break;
    }
  }

 private:
  struct Free {
    void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
    void operator()(LZ4F_dctx* context) const { LZ4F_freeDecompressionContext(context); }
  };

  LZ4F_dctx* Lz4Context() {
    if (lz4_) {
      LZ4F_resetDecompressionContext(lz4_.get());
      return lz4_.get();
    }
    LZ4F_dctx* made = nullptr;
    if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION)) != 0) {
      throw std::bad_alloc();
    }
    lz4_.reset(made);
    return made;
  }

  std::unique_ptr<ZSTD_DCtx, Free> zstd_;
  std::unique_ptr<LZ4F_dctx, Free> lz4_;
};

Decompressor::Decompressor() : contexts_(std::make_unique<Contexts>()) {}
Decompressor::~Decompressor() = default;

std::string_view Decompressor::Chunk(std::string_view bytes, std::string_view compression,
                                     std::uint64_t size) {
  if (size > kMost) throw std::invalid_argument("a chunk is larger than 256 MiB");
  if (compression.empty()) {
    if (bytes.size() != size) throw std::invalid_argument("a chunk's size is not what it says");
    return bytes;
  }
  if (compression == "zstd") {
    contexts_->Zstd(bytes, size);
  } else if (compression == "lz4") {
    contexts_->Lz4(bytes, size);
  } else {
    throw std::invalid_argument("a chunk is neither zstd nor lz4");
  }
  if (!contexts_->result.IsFull()) throw std::invalid_argument("a chunk holds less than it says");
  return contexts_->result.Content();
}

std::string_view Decompressor::Head(std::string_view message, std::size_t most) {
  if (!message.starts_with(kZstdBegin)) return message;
  const bool is_whole = contexts_->Zstd(message, most);
  if (is_whole || contexts_->result.IsFull()) return contexts_->result.Content();
  throw std::invalid_argument("zstd: it ends too early");
}

std::string Unpacked(std::string message) {
  if (!message.starts_with(kZstdBegin)) return message;
  Decompressor decompressor;
  const std::string_view unpacked = decompressor.Head(message, kMost + 1);
  if (unpacked.size() > kMost) throw std::invalid_argument("a message is larger than 256 MiB");
  return std::string(unpacked);
}

}  // namespace fovea::cli
