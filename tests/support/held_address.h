#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <stdexcept>
#include <string>

namespace fovea::testing {

// An address of loopback that nobody else is given until the object ends, while whoever sets
// SO_REUSEADDR, as servers do, may listen on it: now, not yet or again. Who connects is refused
// where nobody listens.
class HeldAddress {
 public:
  HeldAddress() : socket_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    const int on = 1;
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    auto* const any = reinterpret_cast<sockaddr*>(&address);
    socklen_t size = sizeof address;
    if (setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) != 0 ||
        bind(socket_, any, size) != 0 || getsockname(socket_, any, &size) != 0) {
      throw std::runtime_error("no address can be held");
    }
    port_ = ntohs(address.sin_port);
  }
  ~HeldAddress() { close(socket_); }

  HeldAddress(const HeldAddress&) = delete;
  HeldAddress& operator=(const HeldAddress&) = delete;

  std::string Port() const { return std::to_string(port_); }
  std::string Text() const { return "127.0.0.1:" + Port(); }

 private:
  int socket_;
  int port_ = 0;
};

}  // namespace fovea::testing
