#include "server/access/token_table.h"

#include <fstream>
#include <sstream>
#include <utility>

#include "server/access/token_line.h"
#include "server/conversion/field_error.h"

namespace fovea::server {
namespace {

constexpr std::size_t kMaxName = 64;

}  // namespace

TokenTable TokenTable::FromFile(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("--tokens: cannot read " + path);
  TokenTable table;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    InField("--tokens: " + path + ":" + std::to_string(++number), [&] { table.Add(line); });
  }
  return table;
}

void TokenTable::Add(const std::string& line) {
  std::istringstream words(line);
  std::string robot, hash, expires, rest;
  if (!(words >> robot) || robot.front() == '#') return;
  words >> hash >> expires >> rest;
  RequireField(rest.empty(), "\"" + rest + "\"", "is too much; a line is ROBOT SHA256 [EXPIRES]");
  RequireField(robot.size() <= kMaxName, "the robot's name", "has more than 64 characters");
  RequireHash(hash);
  Entry entry{.robot = robot};
  if (!expires.empty()) entry.expires = ParseExpiry(expires);
  RequireField(by_hash_.emplace(hash, std::move(entry)).second, "the token",
               "is there twice; each belongs to one robot");
}

// By hash: neither does the file hold tokens, nor does the time of a comparison tell about them.
const TokenTable::Entry& TokenTable::EntryOf(std::string_view token, Time now) const {
  const auto found = by_hash_.find(HashOfToken(token));
  if (found == by_hash_.end()) throw Unauthenticated("the token is not known");
  if (now >= found->second.expires) throw Unauthenticated("the token has expired");
  return found->second;
}

}  // namespace fovea::server
