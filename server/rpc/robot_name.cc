#include "server/rpc/robot_name.h"

#include <algorithm>

#include "server/conversion/field_error.h"

namespace fovea::server {
namespace {

constexpr const char* kMetadataKey = "fovea-robot";
constexpr std::size_t kMaxLength = 64;

bool IsPrintable(char c) { return c >= ' ' && c <= '~'; }

// "ipv4:10.0.0.7" of "ipv4:10.0.0.7:41234".
std::string HostOfPeer(const std::string& peer) { return peer.substr(0, peer.rfind(':')); }

}  // namespace

std::string RobotName(const std::multimap<grpc::string_ref, grpc::string_ref>& metadata,
                      const std::string& peer) {
  const auto given = metadata.find(kMetadataKey);
  if (given == metadata.end()) return HostOfPeer(peer);
  std::string name(given->second.data(), given->second.size());
  const bool printable = std::all_of(name.begin(), name.end(), IsPrintable);
  RequireField(!name.empty() && name.size() <= kMaxLength && printable,
               std::string("metadata ") + kMetadataKey, "must be 1 to 64 printable characters");
  return name;
}

}  // namespace fovea::server
