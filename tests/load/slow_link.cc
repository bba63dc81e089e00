#include "tests/load/slow_link.h"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <stdexcept>
#include <utility>

namespace fovea::load {
namespace {

constexpr int kPollMs = 50;
constexpr std::size_t kChunksPerSecond = 50;

sockaddr* General(sockaddr_in* address) { return reinterpret_cast<sockaddr*>(address); }

bool HasInput(int file) {
  pollfd wanted{.fd = file, .events = POLLIN, .revents = 0};
  return poll(&wanted, 1, kPollMs) > 0;
}

void SendAll(int to, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t sent = send(to, bytes, count, MSG_NOSIGNAL);
    if (sent <= 0) return;
    bytes += sent;
    count -= static_cast<std::size_t>(sent);
  }
}

}  // namespace

SlowLink::SlowLink(std::string server, std::size_t bytes_per_second)
    : server_(std::move(server)),
      bytes_per_second_(bytes_per_second),
      listener_(RawConnection::Adopt(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0))) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  if (bind(listener_->file(), General(&address), size) != 0 || listen(listener_->file(), 1) != 0 ||
      getsockname(listener_->file(), General(&address), &size) != 0) {
    throw std::runtime_error("cannot listen on loopback");
  }
  port_ = ntohs(address.sin_port);
  accepting_ = std::jthread([this] { Accept(); });
}

SlowLink::~SlowLink() {
  stopping_ = true;
  accepting_.join();
  ways_.clear();
}

std::string SlowLink::Address() const { return "127.0.0.1:" + std::to_string(port_); }

void SlowLink::Accept() {
  while (!stopping_) {
    if (!HasInput(listener_->file())) continue;
    const int robot =
        connections_
            .emplace_back(RawConnection::Adopt(accept(listener_->file(), nullptr, nullptr)))
            ->file();
    const int server = connections_.emplace_back(std::make_unique<RawConnection>(server_))->file();
    ways_.emplace_back([this, robot, server] { HandOn(robot, server, bytes_per_second_); });
    ways_.emplace_back([this, robot, server] { HandOn(server, robot, 0); });
  }
}

void SlowLink::HandOn(int from, int to, std::size_t bytes_per_second) const {
  std::array<char, 65'536> buffer{};
  const std::size_t chunk =
      bytes_per_second == 0
          ? buffer.size()
          : std::clamp<std::size_t>(bytes_per_second / kChunksPerSecond, 1, buffer.size());
  while (!stopping_) {
    if (cut_ || !HasInput(from)) {
      if (cut_) std::this_thread::sleep_for(std::chrono::milliseconds(kPollMs));
      continue;
    }
    const ssize_t count = recv(from, buffer.data(), chunk, 0);
    if (count <= 0) break;
    SendAll(to, buffer.data(), static_cast<std::size_t>(count));
    if (bytes_per_second > 0)
      std::this_thread::sleep_for(std::chrono::microseconds(1'000'000 / kChunksPerSecond));
  }
  shutdown(to, SHUT_WR);
}

}  // namespace fovea::load
