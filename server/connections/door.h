#pragma once

#include <grpcpp/server_builder.h>

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "server/connections/connection_table.h"
#include "server/connections/flood_guard.h"
#include "server/connections/listening_socket.h"

namespace fovea::server {

// Where connections come in: accepts them, instead of gRPC 1.51, whose listener has no limits and
// stays deaf for good once it ran out of file descriptors (grpc#20418, grpc#31080), and hands those
// that find a place to gRPC.
class Door {
 public:
  using Acceptor = grpc::experimental::ExternalConnectionAcceptor;

  // Listens, and accepts nothing yet. Throws std::runtime_error where an address cannot be listened
  // on.
  Door(const std::vector<std::string>& addresses, ConnectionTable& connections);
  ~Door();

  Door(const Door&) = delete;
  Door& operator=(const Door&) = delete;

  const std::vector<ListeningSocket>& listening() const { return listening_; }

  // Begins to accept. `callers` takes connections from outside, `self` those that were announced.
  void Open(std::unique_ptr<Acceptor> callers, std::unique_ptr<Acceptor> self);
  // Accepts no more. Returns when the last one has been handed on.
  void Close();

  // The connection from there that comes next is this process's own: it needs no place and no
  // certificate.
  void Announce(const std::string& peer);

 private:
  void Run(const std::stop_token& stop);
  void OnReady(int fd);
  void Accept(const ListeningSocket& listening);
  void HandOver(const ListeningSocket& listening, FileDescriptor connection);
  void TurnAwayWithoutDescriptor(const ListeningSocket& listening);
  bool WasAnnounced(const std::string& peer);
  void Watch(int fd, std::uint32_t events) const;
  void Inspect();
  void SetAccepting(bool accepting);

  ConnectionTable& connections_;
  FloodGuard flood_guard_;
  bool accepting_ = true;
  ConnectionTable::Clock::time_point next_inspection_{};  // of what connections hold
  std::vector<ListeningSocket> listening_;
  FileDescriptor epoll_, wake_;
  FileDescriptor spare_;  // given up to accept, and close, when there are no more
  std::unique_ptr<Acceptor> callers_, self_;
  std::mutex mutex_;
  std::set<std::string> announced_;
  std::jthread thread_;
};

// How many files this process may have open; as many as the system allows once it was raised.
std::size_t FileLimit();
void RaiseFileLimit();

}  // namespace fovea::server
