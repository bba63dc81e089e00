#include "server/logging/log_record.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <array>
#include <cmath>

#include "server/logging/log_format.h"

namespace fovea::server {
namespace {

constexpr std::size_t kMaxBytes = 300;

// Controls of C0 and C1, line and paragraph separators, and what turns the direction of writing.
bool IsHarmless(std::string_view character) {
  if (character.size() == 1) {
    const char c = character.front();
    return static_cast<unsigned char>(c) >= 0x20 && c != 0x7F && c != '"' && c != '\\';
  }
  if (character.size() == 2) return character < "\xC2\x80" || character > "\xC2\x9F";
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kSteering{
      {{"\xE2\x80\x8E", "\xE2\x80\x8F"},
       {"\xE2\x80\xA8", "\xE2\x80\xAE"},
       {"\xE2\x81\xA6", "\xE2\x81\xA9"}}};
  for (const auto& [first, last] : kSteering) {
    if (character.size() == 3 && character >= first && character <= last) return false;
  }
  return true;
}

}  // namespace

// As Unicode has it (table 3-7): neither longer than needed, nor surrogates, nor beyond U+10FFFF.
std::size_t LengthOfCharacter(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const auto follows = [&](std::size_t i) { return byte(i) >= 0x80 && byte(i) <= 0xBF; };
  const unsigned int first = byte(0), second = byte(1);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return follows(1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    const bool good = (first != 0xE0 || second >= 0xA0) && (first != 0xED || second <= 0x9F);
    return good && follows(1) && follows(2) ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    const bool good = (first != 0xF0 || second >= 0x90) && (first != 0xF4 || second <= 0x8F);
    return good && follows(1) && follows(2) && follows(3) ? 4 : 0;
  }
  return 0;
}

std::string Harmless(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = LengthOfCharacter(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
    result += length > 0 && IsHarmless(character) ? character : "?";
    text.remove_prefix(character.size());
  }
  return result;
}

bool IsUtf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = LengthOfCharacter(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

LogRecord& LogRecord::Text(const std::string& key, std::string_view value) {
  std::size_t size = value.size();
  if (size > kMaxBytes) {  // not in the middle of a character
    size = kMaxBytes;
    while (size > kMaxBytes - 3 && (static_cast<unsigned char>(value[size]) & 0xC0) == 0x80) --size;
  }
  members_.push_back({.key = key, .text = Harmless(value.substr(0, size)), .quoted = true});
  return *this;
}

LogRecord& LogRecord::Word(const std::string& key, const std::string& value) {
  members_.push_back({.key = key, .text = value});
  return *this;
}

LogRecord& LogRecord::Milliseconds(const std::string& key, double value) {
  members_.push_back({.key = key, .text = fmt::format("{:.1f}", value), .is_number = true});
  return *this;
}

LogRecord& LogRecord::Number(const std::string& key, double value) {
  members_.push_back(
      {.key = key, .text = fmt::format("{}", value), .is_number = std::isfinite(value)});
  return *this;
}

std::string LogRecord::AsText() const {
  std::string text = title_;
  for (const Member& member : members_) {
    if (!text.empty()) text += ' ';
    text +=
        fmt::format(fmt::runtime(member.quoted ? "{}=\"{}\"" : "{}={}"), member.key, member.text);
  }
  return text;
}

std::string LogRecord::AsMembers() const {
  std::string text = fmt::format("\"event\":\"{}\"", event_);
  for (const Member& member : members_) {
    const char* format = member.is_number ? ",\"{}\":{}" : ",\"{}\":\"{}\"";
    text += fmt::format(fmt::runtime(format), member.key, member.text);
  }
  return text;
}

void LogRecord::Log(spdlog::level::level_enum level) const {
  if (!spdlog::should_log(level)) return;
  if (GetLogFormat() == LogFormat::kJson) {
    spdlog::default_logger_raw()->log(level, fmt::format("{}{}", kMembersFollow, AsMembers()));
  } else {
    spdlog::default_logger_raw()->log(level, AsText());
  }
}

}  // namespace fovea::server
