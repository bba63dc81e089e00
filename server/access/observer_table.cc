#include "server/access/observer_table.h"

#include <fnmatch.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "server/access/token_line.h"
#include "server/conversion/field_error.h"
#include "server/logging/log_record.h"

namespace fovea::server {
namespace {

constexpr std::size_t kMaxPatterns = 64;

std::vector<std::string> Split(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

ObserverRights ParseRights(const std::string& text) {
  ObserverRights rights;
  for (const std::string& right : Split(text)) {
    bool* const named = right == "view"       ? &rights.view
                        : right == "try"      ? &rights.try_
                        : right == "download" ? &rights.download
                        : right == "pick"     ? &rights.pick
                                              : nullptr;
    RequireField(named != nullptr, "\"" + right + "\"",
                 "is no right; there are view, try, download and pick");
    *named = true;
  }
  RequireField(rights.view, "\"" + text + "\"", "must have view, without which there is nothing");
  return rights;
}

std::vector<std::string> ParsePatterns(const std::string& text) {
  std::vector<std::string> patterns = Split(text);
  const bool whole = std::ranges::none_of(patterns, [](const auto& each) { return each.empty(); });
  RequireField(!patterns.empty() && whole && patterns.size() <= kMaxPatterns, "\"" + text + "\"",
               "must be 1 to 64 patterns of robots with commas between them, * for all");
  RequireField(IsUtf8(text), "\"" + Harmless(text) + "\"", "is no UTF-8");
  return patterns;
}

}  // namespace

bool MatchesAny(const std::vector<std::string>& patterns, const std::string& name) {
  return std::ranges::any_of(patterns, [&](const std::string& pattern) {
    return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
  });
}

bool ObserverEntry::MaySee(const std::string& robot) const {
  return rights.view && MatchesAny(robots, robot);
}

ObserverTable ObserverTable::FromFile(const std::string& path) {
  ObserverTable table;
  ForEachTokenLine("--observers", path, [&](const std::string& line) { table.Add(line); });
  return table;
}

void ObserverTable::Add(const std::string& line) {
  std::istringstream words(line);
  std::string name, hash, rights, robots, expires, rest;
  if (!(words >> name) || name.front() == '#') return;
  words >> hash >> rights >> robots >> expires >> rest;
  RequireTokenName("the name", name);
  hash = ParseHash(hash, line);
  RequireField(rest.empty(), "the sixth word",
               "is too much; a line is NAME SHA256 RIGHTS ROBOTS [EXPIRES]");
  ObserverEntry entry{.name = name, .rights = ParseRights(rights), .robots = ParsePatterns(robots)};
  if (!expires.empty()) entry.expires = ParseExpiry(expires);
  entries_.Add(hash, std::move(entry), "observer");
}

const ObserverEntry& ObserverTable::EntryOf(std::string_view token,
                                            std::chrono::sys_seconds now) const {
  return entries_.Of(token, now);
}

}  // namespace fovea::server
