#include "server/access/gate_keeper.h"

#include <chrono>
#include <string_view>
#include <utility>

#include "server/connections/socket_address.h"
#include "server/rpc/call_names.h"

namespace fovea::server {
namespace {

// "…" of the metadata `authorization: Bearer …`.
std::string_view TokenOf(const Metadata& metadata) {
  constexpr std::string_view kScheme = "Bearer ";
  const auto found = metadata.find("authorization");
  if (found == metadata.end()) {
    throw Unauthenticated("a token is needed: metadata authorization: Bearer TOKEN");
  }
  const std::string_view text(found->second.data(), found->second.size());
  if (!text.starts_with(kScheme)) {
    throw Unauthenticated("metadata authorization: must be Bearer TOKEN");
  }
  return text.substr(kScheme.size());
}

RobotId Certified(const std::string& name) { return {name, name}; }

}  // namespace

GateKeeper::GateKeeper(std::string tokens) : tokens_(std::move(tokens)) { Reload(); }

void GateKeeper::Reload() {
  if (tokens_.empty()) return;
  auto table = std::make_shared<const TokenTable>(TokenTable::FromFile(tokens_));
  const std::lock_guard lock(mutex_);
  table_ = std::move(table);
}

RobotId GateKeeper::Admit(const grpc::ServerContextBase& context) const {
  if (const auto table = Table()) {
    const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
    return Certified(table->RobotOf(TokenOf(context.client_metadata()), now));
  }
  const auto certified = context.auth_context()->GetPeerIdentity();
  if (!certified.empty()) return Certified({certified.front().data(), certified.front().size()});
  const std::string peer = context.peer();
  return {HostOfPeer(peer), RobotName(context.client_metadata(), peer)};
}

bool GateKeeper::RefusesEverybody() const {
  const auto table = Table();
  return table && table->size() == 0;
}

std::shared_ptr<const TokenTable> GateKeeper::Table() const {
  const std::lock_guard lock(mutex_);
  return table_;
}

}  // namespace fovea::server
