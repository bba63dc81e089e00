#include "server/codec/rvl.h"

#include <algorithm>
#include <cstdint>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>

namespace fovea::server {
namespace {

constexpr std::size_t kWordBytes = 4;

[[noreturn]] void Fail(const std::string& message) { throw std::invalid_argument(message); }

// Numbers of three bits a nibble, the lowest first; the fourth bit says that more follow. Nibbles
// fill little-endian words of 32 bits from the top.
class Codes {
 public:
  explicit Codes(std::string_view bytes) : bytes_(bytes) {
    if (bytes.size() % kWordBytes != 0) {
      Fail("has " + std::to_string(bytes.size()) + " bytes; RVL codes fill words of 4");
    }
  }

  std::uint32_t Next() {
    constexpr int kMostBits = 18;
    std::uint32_t number = 0;
    for (int bits = 0; bits < kMostBits; bits += 3) {
      const std::uint32_t nibble = NextNibble();
      number |= (nibble & 7U) << bits;
      if ((nibble & 8U) == 0) return number;
    }
    return NextOfLongRun(number);
  }

  bool AreUsedUp() const { return next_ == bytes_.size(); }
  std::size_t NumLeft() const { return bytes_.size() - next_; }

 private:
  // Runs may be longer than any depth.
  std::uint32_t NextOfLongRun(std::uint32_t number) {
    for (int bits = 18; bits < 30; bits += 3) {
      const std::uint32_t nibble = NextNibble();
      number |= (nibble & 7U) << bits;
      if ((nibble & 8U) == 0) return number;
    }
    Fail("has an RVL code of more than 30 bits");
  }

  std::uint32_t NextNibble() {
    if (num_nibbles_ == 0) ReadWord();
    --num_nibbles_;
    const std::uint32_t nibble = word_ >> 28U;
    word_ <<= 4U;
    return nibble;
  }

  void ReadWord() {
    if (AreUsedUp()) Fail("the RVL codes end before the pixels do");
    const auto byte = [&](std::size_t i) {
      return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes_[next_ + i]));
    };
    word_ = byte(0) | byte(1) << 8U | byte(2) << 16U | byte(3) << 24U;
    next_ += kWordBytes;
    num_nibbles_ = 8;
  }

  std::string_view bytes_;
  std::size_t next_ = 0;
  std::uint32_t word_ = 0;
  int num_nibbles_ = 0;
};

std::size_t NextRun(Codes& codes, std::size_t num_left) {
  const std::size_t run = codes.Next();
  if (run > num_left) {
    Fail("an RVL run of " + std::to_string(run) + " pixels, " + std::to_string(num_left) +
         " are left");
  }
  return run;
}

// Even numbers are 0, 1, 2, …, odd ones -1, -2, ….
int Signed(std::uint32_t number) {
  const int half = static_cast<int>(number >> 1U);
  return (number & 1U) == 0 ? half : -half - 1;
}

}  // namespace

std::size_t MaxRvlBytes(std::size_t num_pixels) {
  constexpr std::size_t kMostNibbles = 8;  // of a pixel: its step in 6, and two lengths of runs
  return num_pixels * kMostNibbles / 2 + 2 * kWordBytes;
}

cv::Mat DecodeRvl(std::string_view bytes, int width, int height) {
  cv::Mat depth(height, width, CV_16UC1);
  Codes codes(bytes);
  auto* const first = depth.ptr<std::uint16_t>();
  std::size_t num_left = depth.total();
  int value = 0;
  for (auto* next = first; num_left > 0;) {
    const std::size_t num_missing = NextRun(codes, num_left);
    next = std::fill_n(next, num_missing, std::uint16_t{0});
    num_left -= num_missing;
    const std::size_t num_measured = NextRun(codes, num_left);
    for (std::size_t i = 0; i < num_measured; ++i) {
      value += Signed(codes.Next());
      if (value < 0 || value > 65535) Fail("an RVL depth of " + std::to_string(value));
      *next++ = static_cast<std::uint16_t>(value);
    }
    num_left -= num_measured;
  }
  if (!codes.AreUsedUp()) {
    Fail("has " + std::to_string(codes.NumLeft()) + " bytes behind the RVL codes");
  }
  return depth;
}

}  // namespace fovea::server
