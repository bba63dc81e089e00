#include "server/access/token_line.h"

#include <google/protobuf/util/time_util.h>
#include <openssl/evp.h>
#include <spdlog/fmt/fmt.h>
#include <strings.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <sstream>

#include "server/access/unauthenticated.h"
#include "server/conversion/field_error.h"

namespace fovea::server {
namespace {

constexpr std::size_t kHashDigits = 64;

bool IsHash(const std::string& word) {
  return word.size() == kHashDigits &&
         word.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos;
}

std::string InSmallLetters(std::string hash) {
  std::ranges::transform(hash, hash.begin(), [](unsigned char c) { return std::tolower(c); });
  return hash;
}

}  // namespace

std::string HashOfToken(std::string_view token) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> hash{};
  unsigned int size = 0;
  EVP_Digest(token.data(), token.size(), hash.data(), &size, EVP_sha256(), nullptr);
  std::string digits;
  for (unsigned int i = 0; i < size; ++i) digits += fmt::format("{:02x}", hash.at(i));
  return digits;
}

std::string ParseHash(const std::string& word, const std::string& line) {
  if (IsHash(word)) return InSmallLetters(word);
  std::istringstream words(line);
  const bool is_later = std::any_of(std::istream_iterator<std::string>(words), {},
                                    [](auto& each) { return IsHash(each); });
  RequireField(!is_later, "the name", "has a blank; it must be one word");
  const bool right_size = word.size() == kHashDigits;
  FailField("the hash", "is not a SHA-256 in 64 hexadecimal digits; it has " +
                            (right_size ? "other characters, too"
                                        : std::to_string(word.size()) + " characters"));
}

std::chrono::sys_seconds ParseExpiry(const std::string& text) {
  google::protobuf::Timestamp time;
  RequireField(google::protobuf::util::TimeUtil::FromString(text, &time), "when it expires",
               "is not a time such as 2027-01-31T12:00:00Z");
  return std::chrono::sys_seconds(std::chrono::seconds(time.seconds()));
}

std::string_view BearerTokenOf(const Metadata& metadata) {
  constexpr std::string_view kScheme = "Bearer ";
  const auto found = metadata.find("authorization");
  if (found == metadata.end()) {
    throw Unauthenticated("a token is needed: metadata authorization: Bearer TOKEN");
  }
  const std::string_view text(found->second.data(), found->second.size());
  if (text.size() < kScheme.size() ||
      strncasecmp(text.data(), kScheme.data(), kScheme.size()) != 0) {
    throw Unauthenticated("metadata authorization: must be Bearer TOKEN");
  }
  return text.substr(kScheme.size());
}

}  // namespace fovea::server
