#include "client/rvl.h"

#include <algorithm>
#include <utility>

namespace fovea::client {
namespace {

// Numbers of three bits a nibble, the lowest first; the fourth bit says that more follow. Nibbles
// fill little-endian words of 32 bits from the top.
class Codes {
 public:
  explicit Codes(std::size_t expected_bytes) { bytes_.reserve(expected_bytes); }

  void Add(std::uint32_t number) {
    for (; number > 7; number >>= 3U) AddNibble(8U | (number & 7U));
    AddNibble(number);
  }

  std::string Finish() && {
    while (num_nibbles_ > 0) AddNibble(0);
    return std::move(bytes_);
  }

 private:
  void AddNibble(std::uint32_t nibble) {
    word_ = word_ << 4U | nibble;
    if (++num_nibbles_ < 8) return;
    const char bytes[] = {static_cast<char>(word_), static_cast<char>(word_ >> 8U),
                          static_cast<char>(word_ >> 16U), static_cast<char>(word_ >> 24U)};
    bytes_.append(bytes, sizeof bytes);
    num_nibbles_ = 0;
  }

  std::string bytes_;
  std::uint32_t word_ = 0;
  int num_nibbles_ = 0;
};

// 0, -1, 1, -2, … become 0, 1, 2, 3, ….
std::uint32_t Unsigned(int step) {
  return step < 0 ? 2 * static_cast<std::uint32_t>(-step) - 1
                  : 2 * static_cast<std::uint32_t>(step);
}

// The numbers again; the server's decoder also says what is wrong with them.
class Numbers {
 public:
  explicit Numbers(std::string_view codes) : codes_(codes) {}

  // False at the end, and for a number that no depth or run has.
  bool Next(std::uint32_t* number) {
    *number = 0;
    for (unsigned bits = 0; bits < 30; bits += 3) {
      const std::size_t byte = 4 * (at_ / 8) + 3 - at_ % 8 / 2;  // words are little-endian
      if (byte >= codes_.size()) return false;
      const auto both = static_cast<unsigned char>(codes_[byte]);
      const std::uint32_t nibble = at_++ % 2 == 0 ? both >> 4U : both & 15U;
      *number |= (nibble & 7U) << bits;
      if ((nibble & 8U) == 0) return true;
    }
    return false;
  }

 private:
  std::string_view codes_;
  std::size_t at_ = 0;  // the next nibble
};

}  // namespace

bool DecodeRvl(std::string_view codes, std::uint16_t* depth, std::size_t num_pixels) {
  if (codes.size() % 4 != 0) return false;
  Numbers numbers(codes);
  std::uint16_t* const end = depth + num_pixels;
  int value = 0;
  while (depth != end) {
    std::uint32_t missing = 0, measured = 0, step = 0;
    if (!numbers.Next(&missing) || missing > static_cast<std::size_t>(end - depth)) return false;
    depth = std::fill_n(depth, missing, std::uint16_t{0});
    if (!numbers.Next(&measured) || measured > static_cast<std::size_t>(end - depth)) return false;
    for (; measured > 0; --measured) {
      if (!numbers.Next(&step)) return false;
      const int half = static_cast<int>(step >> 1U);
      value += (step & 1U) == 0 ? half : -half - 1;
      if (value < 0 || value > 65535) return false;
      *depth++ = static_cast<std::uint16_t>(value);
    }
  }
  return true;
}

std::size_t MaxRvlBytes(std::size_t num_pixels) {
  constexpr std::size_t kMostNibbles = 8;  // of a pixel: its step in 6, and two lengths of runs
  return num_pixels * kMostNibbles / 2 + 8;
}

std::string EncodeRvl(const std::uint16_t* depth, std::size_t num_pixels) {
  Codes codes(num_pixels / 2);
  const std::uint16_t* const end = depth + num_pixels;
  int before = 0;
  while (depth != end) {
    const auto* measured = std::find_if(depth, end, [](std::uint16_t value) { return value != 0; });
    codes.Add(static_cast<std::uint32_t>(measured - depth));
    depth = std::find(measured, end, std::uint16_t{0});
    codes.Add(static_cast<std::uint32_t>(depth - measured));
    for (; measured != depth; ++measured) {
      codes.Add(Unsigned(*measured - before));
      before = *measured;
    }
  }
  return std::move(codes).Finish();
}

}  // namespace fovea::client
