// Log lines of named values.
#pragma once

#include <spdlog/common.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace fovea::server {

// One line: as text `slow request="17" total_ms=181.2`, as JSON an object with the same keys and
// `"event":"slow"`.
class LogRecord {
 public:
  // `event` says what it is about; `title` is how the text begins, often the same.
  explicit LogRecord(const std::string& event) : LogRecord(event, event) {}
  LogRecord(std::string event, std::string title)
      : event_(std::move(event)), title_(std::move(title)) {}

  // From outside: shortened to 300 bytes, and without what could end the value or the line, steer a
  // terminal, or is no UTF-8.
  LogRecord& Text(const std::string& key, std::string_view value);
  // Of few that the server itself chooses; stands without quotation marks.
  LogRecord& Word(const std::string& key, const std::string& value);
  LogRecord& Milliseconds(const std::string& key, double value);
  LogRecord& Number(const std::string& key, double value);

  void Log(spdlog::level::level_enum level) const;

  // `title key=value …`.
  std::string AsText() const;
  // `"event":"…","key":value,…`: the members of a JSON object.
  std::string AsMembers() const;

 private:
  struct Member {
    std::string key, text;
    bool quoted = false, is_number = false;
  };

  const std::string event_, title_;
  std::vector<Member> members_;
};

// How many bytes the valid UTF-8 character at the start takes; 0 = there is none. `text` is not
// empty.
std::size_t LengthOfCharacter(std::string_view text);

// The same for any text: valid UTF-8 without control characters, quotation marks and backslashes,
// each of which becomes a question mark.
std::string Harmless(std::string_view text);

bool IsUtf8(std::string_view text);

}  // namespace fovea::server
