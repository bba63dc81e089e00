// Who may watch: people by the hash of their token.
#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "server/access/token_file.h"

namespace fovea::server {

// What observers may do with the robots that they may see.
struct ObserverRights {
  bool view = false;      // pictures and answers
  bool try_ = false;      // other options on a frame that was kept
  bool download = false;  // what the robot sent
  bool pick = false;      // mark an object for the robot
};

struct ObserverEntry {
  std::string name;
  ObserverRights rights;
  std::vector<std::string> robots;  // patterns of the shell
  std::chrono::sys_seconds expires = std::chrono::sys_seconds::max();

  bool MaySee(const std::string& robot) const;
};

// Whether a pattern of the shell matches the name; "*" matches all.
bool MatchesAny(const std::vector<std::string>& patterns, const std::string& name);

class ObserverTable {
 public:
  // Reads lines of `NAME SHA256 RIGHTS ROBOTS [EXPIRES]`: a name of 1 to 64 characters, the SHA-256
  // of a token, some of view, try, download and pick with commas between, patterns of robots with
  // commas between, and when it ends. The rest is as in TokenTable::FromFile.
  static ObserverTable FromFile(const std::string& path);

  TokenCensus Census(std::chrono::sys_seconds now) const {
    return entries_.Census(now, &ObserverEntry::name);
  }

  // Throws Unauthenticated for a token that is not known or has expired.
  const ObserverEntry& EntryOf(std::string_view token, std::chrono::sys_seconds now) const;

 private:
  void Add(const std::string& line);

  TokenEntries<ObserverEntry> entries_;
};

}  // namespace fovea::server
