#include "client/observer/server_link.h"

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <utility>

#include "client/channel.h"

namespace fovea::observer {
namespace {

std::string TextOf(const client::ServerAddress& address) {
  if (!address.path.empty()) return "unix:" + address.path;
  const bool is_ipv6 = address.host.find(':') != std::string::npos;
  return (is_ipv6 ? "[" + address.host + "]" : address.host) + ":" + address.port;
}

}  // namespace

void OutageNote::OnAway(const std::string& address, const std::string& why) {
  const std::lock_guard lock(mutex_);
  if (std::exchange(is_away_, true)) return;
  std::cerr << "fovea-observer: the server at " << address << " is away: " << why << std::endl;
}

void OutageNote::OnBack(const std::string& address) {
  const std::lock_guard lock(mutex_);
  if (!std::exchange(is_away_, false)) return;
  std::cerr << "fovea-observer: the server at " << address << " is back" << std::endl;
}

client::ServerTarget TargetOf(const client::ServerAddress& address) {
  if (!client::HaveNames({address})) return client::FindTargets({address}).targets.front();
  const std::string text = TextOf(address);
  return {.target = "dns:///" + text, .authority = text};
}

std::vector<ServerLink> LinkServers(const std::string& addresses,
                                    const client::ClientOptions& options) {
  constexpr int kMaxMessageMib = 256;  // frame, answer and pictures at once
  client::ClientOptions of_links = options;
  of_links.max_answer_mib = std::max(options.max_answer_mib, kMaxMessageMib);
  std::vector<ServerLink> links;
  for (const client::ServerAddress& address : client::ParseServerAddresses(addresses)) {
    links.push_back(
        {.address = TextOf(address),
         .channel = client::MakeChannel(TargetOf(address), /*has_others=*/false, of_links)});
  }
  return links;
}

}  // namespace fovea::observer
