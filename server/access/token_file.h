// What files of tokens have in common: lines that begin with a name and the hash of a token.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>

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

  std::size_t size() const { return by_hash_.size(); }

 private:
  std::map<std::string, Entry> by_hash_;
};

}  // namespace fovea::server
