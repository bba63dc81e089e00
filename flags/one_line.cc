#include "flags/one_line.h"

#include <array>
#include <cstdio>

namespace fovea::flags {
namespace {

std::string Escape(unsigned char c) {
  if (c == '\n') return "\\n";
  if (c == '\r') return "\\r";
  if (c == '\t') return "\\t";
  std::array<char, 5> code{};
  std::snprintf(code.data(), code.size(), "\\x%02x", c);
  return code.data();
}

}  // namespace

std::string OneLine(std::string_view text) {
  std::string line;
  line.reserve(text.size());
  unsigned char before = 0;
  for (const char each : text) {
    const auto c = static_cast<unsigned char>(each);
    // Those of C1 are U+0080 to U+009F, for some terminals the same as ESC and a letter.
    const bool is_c1 = before == 0xC2 && c >= 0x80 && c <= 0x9F;
    before = c;
    if (is_c1) line.pop_back();
    if (is_c1 || c < ' ' || c == 0x7F) {
      line += Escape(c);
    } else {
      line += each;
    }
  }
  return line;
}

}  // namespace fovea::flags
