#include "server/access/observer_gate.h"

#include <chrono>
#include <utility>

#include "server/access/token_line.h"
#include "server/access/wall_clock.h"

namespace fovea::server {

ObserverGate::ObserverGate(std::string file) : file_(std::move(file)) { Reload(); }

void ObserverGate::Reload() {
  if (!is_open()) return;
  auto table = std::make_shared<const ObserverTable>(ObserverTable::FromFile(file_));
  const std::lock_guard lock(mutex_);
  table_ = std::move(table);
}

void ObserverGate::RequireUsable() const {
  if (is_open()) ObserverTable::FromFile(file_);
}

ObserverEntry ObserverGate::Admit(const grpc::ServerContextBase& context) const {
  return table()->EntryOf(BearerTokenOf(context.client_metadata()), NowInSeconds());
}

void ObserverGate::LogTokens(bool also_good) const {
  if (is_open()) table()->Census(NowInSeconds()).Log("--observers", file_, also_good);
}

std::shared_ptr<const ObserverTable> ObserverGate::table() const {
  const std::lock_guard lock(mutex_);
  return table_;
}

}  // namespace fovea::server
