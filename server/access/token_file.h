// What files of tokens have in common: lines that begin with a name and the hash of a token.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "server/access/token_census.h"
#include "server/access/token_line.h"
#include "server/access/unauthenticated.h"
#include "server/conversion/field_error.h"

namespace fovea::server {

// Throws std::invalid_argument for a name of a robot or an observer that has more than 64 bytes or
// is no UTF-8, which messages to observers cannot hold. `what`: "the robot's name".
void RequireTokenName(const std::string& what, const std::string& name);

// Calls add(line) for each line of the file that `flag` names. Throws std::runtime_error where
// there is none; of what `add` throws, std::invalid_argument names flag, file and line.
void ForEachTokenLine(const std::string& flag, const std::string& path,
                      const std::function<void(const std::string&)>& add);

// By hash: neither does the file hold tokens, nor does the time of a comparison tell about them.
// `Entry` has `expires`.
template <typename Entry>
class TokenEntries {
 public:
  // `hash`: as ParseHash returns it. Throws std::invalid_argument for one that is there already;
  // `whose`: "robot".
  void Add(const std::string& hash, Entry entry, const std::string& whose) {
    RequireField(by_hash_.emplace(hash, std::move(entry)).second, "the token",
                 "is there twice; each belongs to one " + whose);
  }

  // Throws Unauthenticated for a token that is not known or has expired.
  const Entry& Of(std::string_view token, std::chrono::sys_seconds now) const {
    const auto found = by_hash_.find(HashOfToken(token));
    if (found == by_hash_.end()) throw Unauthenticated("the token is not known");
    if (now >= found->second.expires) throw Unauthenticated("the token has expired");
    return found->second;
  }

  // `name` is the member of an entry that says whose it is. By name.
  TokenCensus Census(std::chrono::sys_seconds now, std::string Entry::*name) const {
    std::vector<const Entry*> entries;
    for (const auto& [hash, entry] : by_hash_) entries.push_back(&entry);
    std::ranges::sort(entries, {}, [name](const Entry* entry) { return entry->*name; });
    TokenCensus census(now);
    for (const Entry* entry : entries) census.Add(entry->*name, entry->expires);
    return census;
  }

 private:
  std::map<std::string, Entry> by_hash_;
};

}  // namespace fovea::server
