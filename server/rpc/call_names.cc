#include "server/rpc/call_names.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <iterator>
#include <optional>

#include "server/connections/socket_address.h"
#include "server/conversion/field_error.h"

namespace fovea::server {
namespace {

constexpr std::size_t kMaxLength = 64;

bool IsPrintable(char c) { return c >= ' ' && c <= '~'; }

std::optional<std::string> NameGiven(const Metadata& metadata, const char* key) {
  const auto given = metadata.find(key);
  if (given == metadata.end()) return std::nullopt;
  std::string name(given->second.data(), given->second.size());
  const bool printable = std::all_of(name.begin(), name.end(), IsPrintable);
  RequireField(!name.empty() && name.size() <= kMaxLength && printable,
               std::string("metadata ") + key, "must be 1 to 64 printable characters");
  return name;
}

}  // namespace

std::string RobotName(const Metadata& metadata, const std::string& peer) {
  return NameGiven(metadata, kRobotKey).value_or(AddressOfPeer(peer));
}

std::optional<TraceContext> TraceOf(const Metadata& metadata) {
  const auto [first, end] = metadata.equal_range("traceparent");
  if (first == end || std::next(first) != end) return std::nullopt;
  return ParseTraceparent({first->second.data(), first->second.size()});
}

std::string RequestId(const Metadata& metadata) {
  static std::atomic<std::uint64_t> last_id = 0;
  const auto given = NameGiven(metadata, kRequestIdKey);
  return given ? *given : std::to_string(++last_id);
}

}  // namespace fovea::server
