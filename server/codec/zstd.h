#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fovea::server {

// Decompresses one zstd frame that must hold exactly `num_bytes` and end where `data` ends.
// Allocates `num_bytes` (the caller has bounded them), whatever the frame claims.
// Throws std::invalid_argument otherwise.
std::string DecompressZstd(std::string_view data, std::size_t num_bytes);

// The same for as many bytes as the frame says that it holds, at most `max_bytes`.
std::string DecompressZstdUpTo(std::string_view data, std::size_t max_bytes);

}  // namespace fovea::server
