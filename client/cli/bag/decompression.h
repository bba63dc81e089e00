// What is compressed in bags; the bytes, and the sizes that they state, may be anything.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace fovea::cli {

// Keeps its memory: in a file of many small chunks new memory for each takes longer than all else.
class Decompressor {
 public:
  Decompressor();
  ~Decompressor();
  Decompressor(const Decompressor&) = delete;
  Decompressor& operator=(const Decompressor&) = delete;

  // What a chunk holds. `compression` as MCAP names it: "", "zstd" or "lz4" (frames). `size` is
  // what the file says of the result; no more than that, and than 256 MiB, is ever allocated. Good
  // until the next call, as `bytes` are. Throws std::invalid_argument where the bytes are none
  // such, or others than `size`.
  std::string_view Chunk(std::string_view bytes, std::string_view compression, std::uint64_t size);

  // How a message begins, for as far as its first `most` bytes, whether it was compressed on its
  // own (compression mode MESSAGE of rosbag2) or not. Good as long. Throws std::invalid_argument.
  std::string_view Head(std::string_view message, std::size_t most);

 private:
  class Contexts;
  const std::unique_ptr<Contexts> contexts_;
};

// A message that was compressed on its own, as it was before; others as they are. Throws
// std::invalid_argument where it is damaged or larger than 256 MiB.
std::string Unpacked(std::string message);

}  // namespace fovea::cli
