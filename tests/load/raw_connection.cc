#include "tests/load/raw_connection.h"

#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <memory>
#include <stdexcept>

namespace fovea::load {
namespace {

using Addresses = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

Addresses Resolve(const std::string& address) {
  const std::size_t colon = address.rfind(':');
  if (colon == std::string::npos) throw std::runtime_error(address + " is not HOST:PORT");
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int error = getaddrinfo(address.substr(0, colon).c_str(), address.substr(colon + 1).c_str(),
                                &hints, &found);
  if (error != 0) throw std::runtime_error(address + ": " + gai_strerror(error));
  return {found, &freeaddrinfo};
}

}  // namespace

RawConnection::RawConnection(const std::string& address) {
  const Addresses addresses = Resolve(address);
  socket_ = socket(addresses->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (connect(socket_, addresses->ai_addr, addresses->ai_addrlen) == 0) return;
  close(socket_);
  throw std::runtime_error("cannot connect to " + address);
}

std::unique_ptr<RawConnection> RawConnection::Adopt(int socket) {
  std::unique_ptr<RawConnection> connection(new RawConnection());
  connection->socket_ = socket;
  return connection;
}

RawConnection::~RawConnection() { close(socket_); }

void RawConnection::Send(const std::string& bytes) const {
  if (send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL) < 0) return;
}

}  // namespace fovea::load
