#pragma once

#include <grpcpp/server_context.h>

#include <memory>
#include <mutex>
#include <string>

#include "server/access/observer_table.h"

namespace fovea::server {

// Lets observers in. Thread-safe.
class ObserverGate {
 public:
  // `file` is for ObserverTable; empty = nobody watches.
  explicit ObserverGate(std::string file);

  bool is_open() const { return !file_.empty(); }

  // Takes over what the file holds now; throws like ObserverTable::FromFile, and changes nothing
  // then. A file without a line is fine: nobody may watch any more.
  void Reload();
  // As GateKeeper::LogTokens().
  void LogTokens(bool also_good) const;
  // What Reload() would throw.
  void RequireUsable() const;

  // Who calls, by token. Throws Unauthenticated.
  ObserverEntry Admit(const grpc::ServerContextBase& context) const;

 private:
  std::shared_ptr<const ObserverTable> table() const;

  const std::string file_;
  mutable std::mutex mutex_;
  std::shared_ptr<const ObserverTable> table_;
};

}  // namespace fovea::server
