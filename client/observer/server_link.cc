#include "client/observer/server_link.h"

#include <algorithm>
#include <stdexcept>

#include "client/channel.h"
#include "client/server_address.h"

namespace fovea::observer {
namespace {

std::string TextOf(const client::ServerAddress& address) {
  if (!address.path.empty()) return "unix:" + address.path;
  const bool is_ipv6 = address.host.find(':') != std::string::npos;
  return (is_ipv6 ? "[" + address.host + "]" : address.host) + ":" + address.port;
}

}  // namespace

std::vector<ServerLink> LinkServers(const std::string& addresses,
                                    const client::ClientOptions& options) {
  constexpr int kMaxMessageMib = 256;  // frame, answer and pictures at once
  client::ClientOptions of_links = options;
  of_links.max_answer_mib = std::max(options.max_answer_mib, kMaxMessageMib);
  std::vector<ServerLink> links;
  for (const client::ServerAddress& address : client::ParseServerAddresses(addresses)) {
    const std::string text = TextOf(address);
    const client::FoundTargets found = client::FindTargets({address});
    const client::ServerTarget target =
        found.targets.empty() ? client::ServerTarget{.target = "dns:///" + text, .authority = text}
                              : found.targets.front();
    links.push_back(
        {.address = text, .channel = client::MakeChannel(target, /*has_others=*/false, of_links)});
  }
  return links;
}

}  // namespace fovea::observer
