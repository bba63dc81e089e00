#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "client/cli/bag/byte_reader.h"

namespace fovea::cli {

// Plain CDR, little-endian: numbers are aligned to their size, texts have a 0 at their end. All
// throw std::invalid_argument where the message is none such or ends before the value does.
class CdrReader {
 public:
  explicit CdrReader(std::string_view message) : reader_(Body(message)) {}

  template <typename Value>
  Value Number() {
    reader_.Align(sizeof(Value));
    return reader_.Number<Value>();
  }
  std::string_view Bytes() {
    reader_.Align(sizeof(std::uint32_t));
    return reader_.Text();
  }
  std::string_view Text() {
    const std::string_view text = Bytes();
    return text.substr(0, text.find('\0'));
  }

 private:
  static std::string_view Body(std::string_view message) {
    constexpr std::string_view kLittleEndian("\x00\x01", 2);
    constexpr std::size_t kHead = 4;
    if (message.size() < kHead || !message.starts_with(kLittleEndian)) {
      throw std::invalid_argument("a message is not in little-endian CDR");
    }
    return message.substr(kHead);
  }

  ByteReader reader_;
};

}  // namespace fovea::cli
