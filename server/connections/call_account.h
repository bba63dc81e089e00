#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "server/connections/connection_table.h"

namespace fovea::server {

// What one call's messages are of what its connection owes. What it has of a message that is not
// whole is given back with this: gRPC gives it up with the call, and not before.
class CallAccount {
 public:
  explicit CallAccount(ConnectionTable& connections) : connections_(connections) {}
  ~CallAccount() {
    if (reads_) connections_.OnNoMessage(peer_, since_);
  }

  CallAccount(const CallAccount&) = delete;
  CallAccount& operator=(const CallAccount&) = delete;

  // The call of this ServerContext::peer() was let in, and is going to read.
  void Admit(std::string peer) {
    peer_ = std::move(peer);
    since_ = connections_.Admit(peer_);
    reads_ = true;
  }
  // A message has come, and the call reads on; or it does not.
  void OnMessage(std::size_t bytes) { since_ = connections_.OnMessage(peer_, since_, bytes); }
  void OnLastMessage(std::size_t bytes) {
    connections_.OnLastMessage(peer_, since_, bytes);
    reads_ = false;
  }
  // An answer of so many bytes was sent, one of many for a message.
  void OnSent(std::size_t bytes) { connections_.OnSent(peer_, bytes); }

 private:
  ConnectionTable& connections_;
  std::string peer_;
  std::uint64_t since_ = 0;  // of the connection's bytes
  bool reads_ = false;
};

}  // namespace fovea::server
