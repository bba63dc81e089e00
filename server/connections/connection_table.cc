#include "server/connections/connection_table.h"

#include <linux/tcp.h>
#include <netinet/in.h>
#include <spdlog/fmt/fmt.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <algorithm>
#include <utility>

#include "server/connections/socket_address.h"
#include "server/logging/failed_handshakes.h"
#include "server/logging/log_limiter.h"

namespace fovea::server {
namespace {

// Bytes that gRPC has read of a connection so far, less those that came while it was asked; 0 of
// UNIX sockets, which do not count them.
std::uint64_t ReceivedOf(int fd) {
  tcp_info info{};
  socklen_t size = sizeof info;
  if (getsockopt(fd, IPPROTO_TCP, TCP_INFO, &info, &size) != 0) return 0;
  int unread = 0;
  ioctl(fd, FIONREAD, &unread);
  const auto waiting = static_cast<std::uint64_t>(std::max(unread, 0));
  return info.tcpi_bytes_received - std::min<std::uint64_t>(info.tcpi_bytes_received, waiting);
}

constexpr std::chrono::seconds kShutOut{5};

// So much may come at once before a call is let in: what gRPC reads in one go can hold thousands.
constexpr int kWindowOfStranger = 32 << 10, kWindow = 64 << 20;

void SetWindow(int fd, int bytes) {
  setsockopt(fd, IPPROTO_TCP, TCP_WINDOW_CLAMP, &bytes, sizeof bytes);
}

// What has come and was not read yet is not read any more, as it would be after shutdown().
void Abort(int fd) {
  const sockaddr none{.sa_family = AF_UNSPEC, .sa_data = {}};
  if (connect(fd, &none, sizeof none) != 0) shutdown(fd, SHUT_RDWR);  // a UNIX socket
}

void LogStranger(const std::string& peer, bool failed) {
  LogLimited(failed ? "handshake failed" : "connection of a stranger",
             failed ? spdlog::level::warn : spdlog::level::debug,
             "connection of " + peer + " ended before a call was let in" +
                 (failed ? ", and a handshake has failed" : ""),
             HostOfPeer(peer));
}

}  // namespace

ConnectionTable::Added ConnectionTable::Add(const std::string& peer, FileDescriptor watched) {
  const std::lock_guard lock(mutex_);
  const std::string host = HostOfPeer(peer);
  const bool shut_out = IsShutOut(host, Clock::now());
  if (!shut_out && !WhyNoPlace(host).empty()) MakePlace(host);
  std::string why_not = shut_out ? "its host sent a flood of calls" : WhyNoPlace(host);
  if (!why_not.empty()) {
    ++counts_.refused;
    return {.why_not = std::move(why_not)};
  }
  ++counts_.accepted;
  ++num_places_;
  ++per_host_[host];
  const int fd = watched.get();
  by_peer_[peer] = fd;
  const auto added = connections_
                         .emplace(fd, Connection{peer, host, std::move(watched),
                                                 ConnectionAccount(Clock::now()), false})
                         .first;
  if (IsUnixPeer(peer))
    added->second.account.Admit();  // all have one name, and are of this machine
  SetWindow(fd, kWindowOfStranger);
  return {.watched = fd};
}

void ConnectionTable::Remove(int watched) {
  const std::lock_guard lock(mutex_);
  const auto found = connections_.find(watched);
  if (found == connections_.end()) return;
  Connection& connection = found->second;
  // gRPC closes a connection once it has said that a handshake failed. Another one that ends just
  // then may be taken for it. Calls of UNIX sockets are those of all of them.
  const bool is_stranger = !connection.account.admitted();
  const bool failed = (is_stranger || IsUnixPeer(connection.peer)) && TakeFailedHandshake();
  if (!connection.ended) {
    GiveBackPlace(connection);
    if (is_stranger) LogStranger(connection.peer, failed);
  }
  const auto by_peer = by_peer_.find(connection.peer);
  if (by_peer != by_peer_.end() && by_peer->second == watched) by_peer_.erase(by_peer);
  connections_.erase(found);
}

bool ConnectionTable::IsShutOut(const std::string& host, Clock::time_point now) {
  std::erase_if(shut_out_, [now](const auto& entry) { return entry.second < now; });
  return shut_out_.contains(host);
}

std::string ConnectionTable::WhyNoPlace(const std::string& host) const {
  constexpr std::size_t kMaxClosing = 64;
  const auto max = static_cast<std::size_t>(limits_.max_connections);
  if (num_places_ >= max) return fmt::format("there are {} already (--max-connections)", max);
  if (connections_.size() >= max + kMaxClosing) return "those that were ended are not closed yet";
  const auto of_host = per_host_.find(host);
  if (of_host == per_host_.end() || of_host->second < limits_.max_per_host) return "";
  return fmt::format("its host has {} already (--max-connections-per-host)", of_host->second);
}

void ConnectionTable::MakePlace(const std::string& host) {
  const auto own = per_host_.find(host);
  const bool of_own = own != per_host_.end() && own->second >= limits_.max_per_host;
  const int num_own = own == per_host_.end() ? 0 : own->second;
  // A caller that has just come may not have had the time to call; but a host with many of them
  // keeps nobody out who has fewer.
  const auto before = Clock::now() - std::chrono::seconds{1};
  Connection* oldest = nullptr;
  for (auto& [fd, candidate] : connections_) {
    const ConnectionAccount& account = candidate.account;
    if (candidate.ended || account.admitted()) continue;
    if (account.accepted() > before && per_host_.at(candidate.host) <= num_own + 1) continue;
    if (of_own && candidate.host != host) continue;
    const auto rank = [&](const Connection& one) {
      return std::pair(-per_host_.at(one.host), one.account.accepted());
    };
    if (oldest == nullptr || rank(candidate) < rank(*oldest)) oldest = &candidate;
  }
  if (oldest != nullptr) End(*oldest, "had no call let in, and others need its place");
}

std::uint64_t ConnectionTable::Admit(const std::string& peer) {
  const std::lock_guard lock(mutex_);
  Connection* connection = Find(peer);
  if (connection == nullptr) return 0;
  if (!connection->account.admitted()) SetWindow(connection->fd.get(), kWindow);
  connection->account.Admit();
  connection->account.OnReceived(ReceivedOf(connection->fd.get()), Clock::now());
  return connection->account.BeginReading();
}

std::uint64_t ConnectionTable::OnMessage(const std::string& peer, std::uint64_t since,
                                         std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  Connection* connection = Find(peer);
  if (connection == nullptr) return 0;
  CountMessage(*connection, since, bytes);
  return connection->account.BeginReading();
}

void ConnectionTable::OnLastMessage(const std::string& peer, std::uint64_t since,
                                    std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  if (Connection* connection = Find(peer)) CountMessage(*connection, since, bytes);
}

void ConnectionTable::CountMessage(Connection& connection, std::uint64_t since, std::size_t bytes) {
  const auto now = Clock::now();
  connection.account.OnReceived(ReceivedOf(connection.fd.get()), now);
  connection.account.OnMessage(bytes, now);
  connection.account.EndReading(since);
}

void ConnectionTable::OnNoMessage(const std::string& peer, std::uint64_t since) {
  const std::lock_guard lock(mutex_);
  Connection* connection = Find(peer);
  if (connection == nullptr) return;
  connection->account.OnReceived(ReceivedOf(connection->fd.get()), Clock::now());
  connection->account.Forgive(since);
}

void ConnectionTable::OnSent(const std::string& peer, std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  if (Connection* connection = Find(peer)) connection->account.OnSent(bytes);
}

void ConnectionTable::OnBegunCalls(const std::vector<CallsOfConnection>& calls,
                                   std::uint64_t max_calls_s) {
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  for (const auto& [peer, begun] : calls) {
    if (IsUnixPeer(peer)) continue;  // all have one name
    Connection* connection = Find(peer);
    if (connection == nullptr || connection->ended) continue;
    connection->account.OnBegunCalls(begun, max_calls_s, now);
    const auto fault = connection->account.Fault(limits_.account, now);
    if (fault) End(*connection, *fault);
  }
}

bool ConnectionTable::IsOpen(const std::string& peer) {
  if (IsUnixPeer(peer)) return true;  // all have one name
  const std::lock_guard lock(mutex_);
  const Connection* connection = Find(peer);
  return connection != nullptr && !connection->ended;
}

bool ConnectionTable::Inspect() {
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  counts_.receiving_bytes = 0;
  for (auto& [fd, connection] : connections_) {
    if (connection.ended) continue;
    connection.account.OnReceived(ReceivedOf(fd), now);
    if (const auto fault = connection.account.Fault(limits_.account, now)) {
      End(connection, *fault);
    } else {
      counts_.receiving_bytes += connection.account.owed();
    }
  }
  const bool much = counts_.receiving_bytes > limits_.max_receiving / 8;
  while (counts_.receiving_bytes > limits_.max_receiving) EndLargest();
  return much;
}

// What is held for long counts more than what has just come: robots that send much send it on.
void ConnectionTable::EndLargest() {
  const auto weight = [](const Connections::value_type& entry) {
    const ConnectionAccount& account = entry.second.account;
    return entry.second.ended ? 0 : 4 * account.held() + account.owed();
  };
  const auto largest =
      std::max_element(connections_.begin(), connections_.end(),
                       [&](const auto& a, const auto& b) { return weight(a) < weight(b); });
  const std::uint64_t owed = largest->second.account.owed();
  counts_.receiving_bytes -= std::min(counts_.receiving_bytes, std::max<std::uint64_t>(owed, 1));
  End(largest->second,
      "sent " + std::to_string(owed) +
          " bytes that make no message, the most while all together sent too many");
}

ConnectionTable::Connection* ConnectionTable::Find(const std::string& peer) {
  const auto found = by_peer_.find(peer);
  return found == by_peer_.end() ? nullptr : &connections_.at(found->second);
}

void ConnectionTable::End(Connection& connection, const std::string& why) {
  connection.ended = true;
  ++counts_.ended;
  GiveBackPlace(connection);
  if (connection.account.IsFlooding()) shut_out_[connection.host] = Clock::now() + kShutOut;
  Abort(connection.fd.get());  // gRPC closes what is left of it
  LogLimited("connection ended", spdlog::level::warn,
             fmt::format("connection of {} ended: it {}", connection.peer, why));
}

void ConnectionTable::GiveBackPlace(const Connection& connection) {
  --num_places_;
  if (--per_host_.at(connection.host) == 0) per_host_.erase(connection.host);
}

ConnectionTable::Counts ConnectionTable::counts() const {
  const std::lock_guard lock(mutex_);
  Counts counts = counts_;
  counts.open = connections_.size();
  return counts;
}

}  // namespace fovea::server
