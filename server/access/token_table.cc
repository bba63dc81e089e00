#include "server/access/token_table.h"

#include <sstream>
#include <utility>

#include "server/access/token_line.h"
#include "server/conversion/field_error.h"

namespace fovea::server {
TokenTable TokenTable::FromFile(const std::string& path) {
  TokenTable table;
  ForEachTokenLine("--tokens", path, [&](const std::string& line) { table.Add(line); });
  return table;
}

void TokenTable::Add(const std::string& line) {
  std::istringstream words(line);
  std::string robot, hash, expires, rest;
  if (!(words >> robot) || robot.front() == '#') return;
  words >> hash >> expires >> rest;
  RequireTokenName("the robot's name", robot);
  hash = ParseHash(hash, line);
  RequireField(rest.empty(), "the fourth word", "is too much; a line is ROBOT SHA256 [EXPIRES]");
  Entry entry{.robot = robot};
  if (!expires.empty()) entry.expires = ParseExpiry(expires);
  entries_.Add(hash, std::move(entry), "robot");
}

const TokenTable::Entry& TokenTable::EntryOf(std::string_view token, Time now) const {
  return entries_.Of(token, now);
}

}  // namespace fovea::server
