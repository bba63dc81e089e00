#include "server/access/gate_keeper.h"

#include <chrono>
#include <string_view>
#include <utility>

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

}  // namespace

GateKeeper::GateKeeper(std::string tokens) : tokens_(std::move(tokens)) { Reload(); }

void GateKeeper::Reload() {
  if (tokens_.empty()) return;
  auto table = std::make_shared<const TokenTable>(TokenTable::FromFile(tokens_));
  const std::lock_guard lock(mutex_);
  table_ = std::move(table);
}

std::string GateKeeper::Admit(const grpc::ServerContextBase& context) const {
  if (const auto table = Table()) {
    const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
    return table->RobotOf(TokenOf(context.client_metadata()), now);
  }
  const auto certified = context.auth_context()->GetPeerIdentity();
  if (!certified.empty()) return {certified.front().data(), certified.front().size()};
  return RobotName(context.client_metadata(), context.peer());
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
