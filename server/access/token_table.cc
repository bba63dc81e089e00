#include "server/access/token_table.h"

#include <google/protobuf/util/time_util.h>
#include <openssl/evp.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <utility>

#include "server/conversion/field_error.h"

namespace fovea::server {
namespace {

constexpr std::size_t kMaxName = 64, kHashDigits = 64;

std::string Sha256(std::string_view text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> hash{};
  unsigned int size = 0;
  EVP_Digest(text.data(), text.size(), hash.data(), &size, EVP_sha256(), nullptr);
  std::string digits;
  for (unsigned int i = 0; i < size; ++i) digits += fmt::format("{:02x}", hash.at(i));
  return digits;
}

bool IsHash(const std::string& text) {
  return text.size() == kHashDigits &&
         text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

TokenTable::Time ParseTime(const std::string& text) {
  google::protobuf::Timestamp time;
  RequireField(google::protobuf::util::TimeUtil::FromString(text, &time), "\"" + text + "\"",
               "is not a time such as 2027-01-31T12:00:00Z");
  return TokenTable::Time(std::chrono::seconds(time.seconds()));
}

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
  RequireField(IsHash(hash), "\"" + hash + "\"", "is not a SHA-256 in 64 hexadecimal digits");
  Entry entry{.robot = robot};
  if (!expires.empty()) entry.expires = ParseTime(expires);
  RequireField(by_hash_.emplace(hash, std::move(entry)).second, "the token",
               "is there twice; each belongs to one robot");
}

// By hash: neither does the file hold tokens, nor does the time of a comparison tell about them.
const TokenTable::Entry& TokenTable::EntryOf(std::string_view token, Time now) const {
  const auto found = by_hash_.find(Sha256(token));
  if (found == by_hash_.end()) throw Unauthenticated("the token is not known");
  if (now >= found->second.expires) throw Unauthenticated("the token has expired");
  return found->second;
}

}  // namespace fovea::server
