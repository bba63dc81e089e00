#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <type_traits>

namespace fovea::cli {

// Little-endian values one after another, from bytes that may be anything. All throw
// std::invalid_argument where the bytes end before the value does.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <typename Value>
  Value Number() {
    static_assert(std::is_arithmetic_v<Value> && std::endian::native == std::endian::little);
    Value value;
    std::memcpy(&value, Bytes(sizeof value).data(), sizeof value);
    return value;
  }

  std::string_view Bytes(std::uint64_t count) {
    if (count > bytes_.size() - position_) throw std::invalid_argument("it ends too early");
    const std::string_view bytes = bytes_.substr(position_, static_cast<std::size_t>(count));
    position_ += bytes.size();
    return bytes;
  }

  // Behind their number, which has 32 bits.
  std::string_view Text() { return Bytes(Number<std::uint32_t>()); }

  // To a multiple of `size` from the first byte.
  void Align(std::size_t size) { Bytes((size - position_ % size) % size); }

  std::string_view Rest() { return Bytes(bytes_.size() - position_); }
  std::size_t position() const { return position_; }
  bool AtEnd() const { return position_ == bytes_.size(); }

 private:
  std::string_view bytes_;
  std::size_t position_ = 0;
};

}  // namespace fovea::cli
