#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace fovea::cli {

// What a chunk holds. `compression` as MCAP names it: "", "zstd" or "lz4" (frames). `size` is what
// the file says of the result; no more than that, and than 256 MiB, is ever allocated, and no more
// than there is. Throws std::invalid_argument where the bytes are none such, or others than `size`.
std::string Decompress(std::string_view bytes, std::string_view compression, std::uint64_t size);

}  // namespace fovea::cli
