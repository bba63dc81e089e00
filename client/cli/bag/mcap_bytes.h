#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace fovea::cli {

// Bytes that are read part by part, by several threads at once.
struct McapBytes {
  std::uint64_t size = 0;
  // Throws std::invalid_argument where they are not there, or not any more.
  std::function<std::string(std::uint64_t start, std::uint64_t size)> part = {};
};

// Of `bytes`, which live as long as what is returned.
McapBytes McapInMemory(std::string_view bytes);
// Of a file that others may shorten meanwhile. Throws std::invalid_argument where it is none.
McapBytes McapInFile(const std::string& path);

}  // namespace fovea::cli
