#include "server/access/gate_keeper.h"

#include <grpc/grpc_security_constants.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "server/access/token_line.h"
#include "server/access/wall_clock.h"
#include "server/connections/socket_address.h"
#include "server/rpc/call_names.h"

namespace fovea::server {
namespace {

RobotId Certified(const std::string& name) { return {name, name}; }

std::string PropertyOf(const grpc::AuthContext& peer, const char* name) {
  const auto values = peer.FindPropertyValues(name);
  return values.empty() ? "" : std::string(values.front().data(), values.front().size());
}

std::chrono::sys_seconds CertifiedUntil(const ClientAuthority& authority,
                                        const grpc::AuthContext& peer) {
  const std::string certificate = PropertyOf(peer, GRPC_X509_PEM_CERT_PROPERTY_NAME);
  if (certificate.empty()) throw Unauthenticated("a client certificate is needed");
  try {
    return authority.GoodUntil(certificate,
                               PropertyOf(peer, GRPC_X509_PEM_CERT_CHAIN_PROPERTY_NAME));
  } catch (const std::exception& error) {
    throw Unauthenticated(error.what());
  }
}

}  // namespace

GateKeeper::GateKeeper(std::string tokens, std::shared_ptr<const ClientAuthority> authority)
    : tokens_(std::move(tokens)) {
  rules_.authority = std::move(authority);
  if (tokens_.empty()) return;
  rules_.tokens = std::make_shared<const TokenTable>(TokenTable::FromFile(tokens_));
}

void GateKeeper::Reload() {
  if (tokens_.empty()) return;
  auto table = std::make_shared<const TokenTable>(TokenTable::FromFile(tokens_));
  if (!table->Census(NowInSeconds()).has_good() && !RefusesEverybody()) {
    throw std::invalid_argument("--tokens: " + tokens_ +
                                " holds 0 tokens that have not expired: nobody could call");
  }
  const std::lock_guard lock(mutex_);
  rules_.tokens = std::move(table);
  ++rules_.number;
}

void GateKeeper::SetAuthority(std::shared_ptr<const ClientAuthority> authority) {
  const std::lock_guard lock(mutex_);
  rules_.authority = std::move(authority);
  ++rules_.number;
}

Admission GateKeeper::Admit(const grpc::ServerContextBase& context) const {
  const Rules rules = this->rules();
  Admission admission;
  admission.rules = rules.number;
  const auto peer = context.auth_context();
  if (rules.authority) admission.expires = CertifiedUntil(*rules.authority, *peer);
  if (rules.tokens) {
    const TokenTable::Entry& entry =
        rules.tokens->EntryOf(BearerTokenOf(context.client_metadata()), NowInSeconds());
    admission.robot = Certified(entry.robot);
    admission.expires = std::min(admission.expires, entry.expires);
    return admission;
  }
  const auto certified = peer->GetPeerIdentity();
  if (!certified.empty()) {
    admission.robot = Certified({certified.front().data(), certified.front().size()});
  } else {
    const std::string address = context.peer();
    admission.robot = {HostOfPeer(address), RobotName(context.client_metadata(), address)};
  }
  return admission;
}

void GateKeeper::Readmit(const grpc::ServerContextBase& context, Admission* admission) const {
  if (rules().number == admission->rules && NowInSeconds() < admission->expires) return;
  const Admission again = Admit(context);
  if (again.robot.name != admission->robot.name)
    throw Unauthenticated("the token is another robot's now");
  admission->expires = again.expires;
  admission->rules = again.rules;
}

bool GateKeeper::RefusesEverybody() const {
  const auto tokens = rules().tokens;
  return tokens && !tokens->Census(NowInSeconds()).has_good();
}

void GateKeeper::LogTokens(bool also_good) const {
  const auto tokens = rules().tokens;
  if (tokens) tokens->Census(NowInSeconds()).Log("--tokens", tokens_, also_good);
}

GateKeeper::Rules GateKeeper::rules() const {
  const std::lock_guard lock(mutex_);
  return rules_;
}

}  // namespace fovea::server
