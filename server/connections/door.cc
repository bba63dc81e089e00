#include "server/connections/door.h"

#include <fcntl.h>
#include <spdlog/fmt/fmt.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/resource.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

#include "server/connections/socket_address.h"
#include "server/log_exception.h"
#include "server/logging/log_limiter.h"

namespace fovea::server {
namespace {

using Clock = std::chrono::steady_clock;

// So often calls are counted, and what connections hold is looked at unless much is on its way:
// what comes in between is not bounded.
constexpr std::chrono::milliseconds kLook{10}, kInspection{100};
// Accepted in one go before the others are heard.
constexpr int kBatch = 64;
constexpr std::chrono::milliseconds kRest{10};

FileDescriptor Spare() { return FileDescriptor(open("/dev/null", O_RDONLY | O_CLOEXEC)); }

}  // namespace

std::size_t FileLimit() {
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  return limit.rlim_cur;
}

void RaiseFileLimit() {
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_NOFILE, &limit);
}

Door::Door(const std::vector<std::string>& addresses, ConnectionTable& connections)
    : connections_(connections),
      flood_guard_(connections),
      epoll_(epoll_create1(EPOLL_CLOEXEC)),
      wake_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      spare_(Spare()) {
  listening_.reserve(addresses.size());
  for (const std::string& address : addresses) listening_.emplace_back(address);
  Watch(wake_.get(), EPOLLIN);
}

Door::~Door() { Close(); }

void Door::Open(std::unique_ptr<Acceptor> callers, std::unique_ptr<Acceptor> self) {
  callers_ = std::move(callers);
  self_ = std::move(self);
  for (const ListeningSocket& listening : listening_) Watch(listening.fd(), EPOLLIN);
  thread_ = std::jthread([this](const std::stop_token& stop) { Run(stop); });
}

void Door::Close() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  eventfd_write(wake_.get(), 1);
  thread_.join();
  listening_.clear();
}

void Door::Announce(const std::string& peer) {
  const std::lock_guard lock(mutex_);
  announced_.insert(peer);
}

bool Door::WasAnnounced(const std::string& peer) {
  const std::lock_guard lock(mutex_);
  return announced_.erase(peer) > 0;
}

void Door::Watch(int fd, std::uint32_t events) const {
  epoll_event event{.events = events, .data = {.fd = fd}};
  epoll_ctl(epoll_.get(), EPOLL_CTL_ADD, fd, &event);
}

void Door::Run(const std::stop_token& stop) {
  std::array<epoll_event, kBatch> events{};
  Clock::time_point next = Clock::now();
  while (!stop.stop_requested()) {
    const bool nobody = connections_.counts().open == 0 && accepting_;
    const int timeout = nobody ? -1 : static_cast<int>(kLook.count());
    const int found = epoll_wait(epoll_.get(), events.data(), kBatch, timeout);
    for (int i = 0; i < found; ++i) {
      const int fd = events.at(static_cast<std::size_t>(i)).data.fd;
      // One connection for which there is no memory ends no others.
      CallOrLog("a connection was not looked at", [&] { OnReady(fd); });
    }
    if (Clock::now() < next) continue;
    CallOrLog("connections were not looked at", [&] { Inspect(); });
    next = Clock::now() + kLook;
  }
}

void Door::OnReady(int fd) {
  const auto listening = std::ranges::find(listening_, fd, &ListeningSocket::fd);
  if (listening != listening_.end()) return Accept(*listening);
  if (fd == wake_.get()) return;
  // Closing it does not end this: gRPC has a descriptor of the same connection.
  epoll_ctl(epoll_.get(), EPOLL_CTL_DEL, fd, nullptr);
  connections_.Remove(fd);
}

void Door::Inspect() {
  const auto now = Clock::now();
  if (now >= next_inspection_) {
    next_inspection_ = now + (connections_.Inspect() ? kLook : kInspection);
  }
  flood_guard_.Inspect(now);
  SetAccepting(!flood_guard_.IsFlooded());
}

// Callers stay in line meanwhile.
void Door::SetAccepting(bool accepting) {
  if (accepting == accepting_) return;
  accepting_ = accepting;
  for (const ListeningSocket& listening : listening_) {
    epoll_event event{.events = accepting ? EPOLLIN : 0U, .data = {.fd = listening.fd()}};
    epoll_ctl(epoll_.get(), EPOLL_CTL_MOD, listening.fd(), &event);
  }
}

void Door::Accept(const ListeningSocket& listening) {
  for (int i = 0; i < kBatch; ++i) {
    FileDescriptor connection(
        accept4(listening.fd(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
    if (connection) {
      HandOver(listening, std::move(connection));
    } else if (errno == EMFILE || errno == ENFILE) {
      TurnAwayWithoutDescriptor(listening);
      return;
    } else if (errno != ECONNABORTED && errno != EINTR) {
      if (errno == EAGAIN) return;
      LogLimited("connection not accepted", spdlog::level::err,
                 std::string("cannot accept connections: ") + std::strerror(errno));
      std::this_thread::sleep_for(kRest);  // it stays in line, and would be heard again at once
      return;
    }
  }
}

void Door::HandOver(const ListeningSocket& listening, FileDescriptor connection) {
  const std::string peer = SocketAddress::Remote(connection.get()).Uri();
  const bool own = WasAnnounced(peer);
  if (!own) {
    FileDescriptor watched(fcntl(connection.get(), F_DUPFD_CLOEXEC, 0));
    if (!watched) return;  // and so `connection` is closed
    const ConnectionTable::Added added = connections_.Add(peer, std::move(watched));
    if (added.watched < 0) {
      LogLimited("connection refused", spdlog::level::warn,
                 "connection of " + peer + " refused: " + added.why_not);
      return;
    }
    Watch(added.watched, EPOLLET);  // of its end, which is always said
  }
  Acceptor::NewConnectionParameters parameters;
  parameters.listener_fd = listening.fd();
  parameters.fd = connection.Release();
  (own ? self_ : callers_)->HandleNewConnection(&parameters);
}

// Else the caller stays in line, and the line is said to be waiting at once again.
void Door::TurnAwayWithoutDescriptor(const ListeningSocket& listening) {
  LogLimited(
      "connection refused", spdlog::level::err,
      fmt::format("connection refused: {} (raise the limit of open files)", std::strerror(errno)));
  if (!spare_) std::this_thread::sleep_for(kRest);
  spare_.Close();
  FileDescriptor refused(accept4(listening.fd(), nullptr, nullptr, SOCK_CLOEXEC));
  refused.Close();
  spare_ = Spare();
}

}  // namespace fovea::server
