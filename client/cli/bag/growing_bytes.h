#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace fovea::cli {

// Grow as bytes come, since the size that a file states may be a lie, and keep their memory.
class GrowingBytes {
 public:
  void Clear(std::uint64_t most) {
    most_ = static_cast<std::size_t>(most);
    filled_ = 0;
  }
  bool IsFull() const { return filled_ == most_; }
  // For the next bytes, of which there must be some.
  std::size_t Room() {
    constexpr std::size_t kFirst = std::size_t{1} << 16;
    if (filled_ == bytes_.size()) {
      bytes_.resize(std::min(most_, std::max(kFirst, 2 * bytes_.size())));
    }
    return std::min(most_, bytes_.size()) - filled_;
  }
  char* end() { return bytes_.data() + filled_; }
  void Filled(std::size_t count) { filled_ += count; }
  std::string_view Content() const { return std::string_view(bytes_).substr(0, filled_); }

 private:
  std::string bytes_;
  std::size_t most_ = 0, filled_ = 0;
};

}  // namespace fovea::cli
