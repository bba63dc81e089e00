#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

#include "server/connections/begun_calls.h"
#include "server/connections/connection_account.h"
#include "server/connections/file_descriptor.h"

namespace fovea::server {

struct ConnectionLimits {
  int max_connections = 1024;
  int max_per_host = 512;
  // Of all connections, bytes that no message has come of yet.
  std::size_t max_receiving = std::size_t{512} << 20;
  AccountLimits account;
};

// The connections that are open and what each holds. Keeps a second descriptor of each, which tells
// what the connection does while gRPC has the first, and can end it. Thread-safe.
class ConnectionTable {
 public:
  using Clock = ConnectionAccount::Clock;

  // What became of connections, since the start.
  struct Counts {
    std::size_t open = 0;
    std::uint64_t accepted = 0;
    std::uint64_t refused = 0;  // no place was left
    std::uint64_t ended = 0;    // had to go
    std::uint64_t receiving_bytes = 0;
  };

  explicit ConnectionTable(const ConnectionLimits& limits) : limits_(limits) {}

  // The descriptor by which Ended() is told of a connection that was taken in; -1 where there is no
  // place for it, and why.
  struct Added {
    int watched = -1;
    std::string why_not = {};
  };

  // Takes the connection in where there is a place. When all places are taken, a connection on
  // which no call was let in makes room, the oldest one of the host that has most. A host whose
  // connection was ended for a flood of calls has no place for 5 s: what these left in gRPC is
  // cleared away meanwhile.
  Added Add(const std::string& peer, FileDescriptor watched);
  // Both ends have closed it.
  void Remove(int watched);

  // A call of this ServerContext::peer() was let in, and a message of it may come: since when, as
  // the account counts; see CallAccount. A peer that is not known (any more) owes nothing.
  std::uint64_t Admit(const std::string& peer);
  // It has come, and another one may: since when. Or none comes after it.
  std::uint64_t OnMessage(const std::string& peer, std::uint64_t since, std::size_t bytes);
  void OnLastMessage(const std::string& peer, std::uint64_t since, std::size_t bytes);
  // The call ended without it.
  void OnNoMessage(const std::string& peer, std::uint64_t since);
  // A message of so many bytes was sent over the connection.
  void OnSent(const std::string& peer, std::size_t bytes);
  // Calls that were begun on connections so far. Ends those that begin more than `max_calls_s`, or
  // fewer where none was let in.
  void OnBegunCalls(const std::vector<CallsOfConnection>& calls, std::uint64_t max_calls_s);
  // False once it was ended or closed.
  bool IsOpen(const std::string& peer);

  // Looks at all, and ends those that hold more, or longer, than the limits allow. True where all
  // together hold so much that they had better be looked at again soon.
  bool Inspect();

  Counts counts() const;

 private:
  struct Connection {
    std::string peer, host;
    FileDescriptor fd;
    ConnectionAccount account;
    bool ended = false;  // by us, and not closed yet
  };
  using Connections = std::map<int, Connection>;  // by fd

  bool IsShutOut(const std::string& host, Clock::time_point now);
  std::string WhyNoPlace(const std::string& host) const;  // empty: there is one
  void MakePlace(const std::string& host);
  Connection* Find(const std::string& peer);
  static void CountMessage(Connection& connection, std::uint64_t since, std::size_t bytes);
  void End(Connection& connection, const std::string& why);
  void EndLargest();
  void GiveBackPlace(const Connection& connection);

  const ConnectionLimits limits_;
  mutable std::mutex mutex_;
  Connections connections_;
  std::unordered_map<std::string, int> by_peer_;
  std::map<std::string, int> per_host_;
  std::map<std::string, Clock::time_point> shut_out_;  // hosts of floods, and until when
  std::size_t num_places_ = 0;                         // of connections_, those that were not ended
  Counts counts_;
};

}  // namespace fovea::server
