// Who may call: robots by the hash of their token.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "server/access/token_file.h"

namespace fovea::server {

class TokenTable {
 public:
  // In whole seconds, since years beyond 2262 do not fit the nanoseconds of a time_point.
  using Time = std::chrono::sys_seconds;

  // Reads lines of `ROBOT SHA256 [EXPIRES]`: a name of 1 to 64 printable characters without spaces,
  // the SHA-256 of its token in 64 hexadecimal digits, and when it ends, as 2027-01-31T12:00:00Z.
  // Empty lines and those that start with # are skipped. A robot may have several tokens.
  // Throws std::invalid_argument that names the line, std::runtime_error where there is no file.
  static TokenTable FromFile(const std::string& path);

  TokenCensus Census(Time now) const { return entries_.Census(now, &Entry::robot); }

  struct Entry {
    std::string robot;
    Time expires = Time::max();
  };

  // Whose this token is, and until when. Throws Unauthenticated for one that is not known or has
  // expired.
  const Entry& EntryOf(std::string_view token, Time now) const;

 private:
  void Add(const std::string& line);

  TokenEntries<Entry> entries_;
};

}  // namespace fovea::server
