#include "server/connections/listening_socket.h"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "server/connections/socket_address.h"
#include "server/server_options.h"

namespace fovea::server {
namespace {

[[noreturn]] void Fail(const std::string& address, const std::string& why) {
  throw std::runtime_error("--listen: cannot listen on " + address + ": " + why);
}

void Switch(int fd, int level, int option, int value) {
  setsockopt(fd, level, option, &value, sizeof value);
}

SocketAddress Resolve(const std::string& address) {
  std::string host = HostOf(address);
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  const std::string port = address.substr(address.rfind(':') + 1);
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
  addrinfo* found = nullptr;
  const int error = getaddrinfo(host.c_str(), port.c_str(), &hints, &found);
  if (error != 0) Fail(address, gai_strerror(error));
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> addresses(found, &freeaddrinfo);
  return {addresses->ai_addr, addresses->ai_addrlen};
}

bool SomebodyListens(const SocketAddress& address) {
  const FileDescriptor probe(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  return connect(probe.get(), address.get(), address.size()) == 0 || errno == EAGAIN;
}

// A server that was killed leaves its file.
void RemoveStale(const std::string& path, const SocketAddress& address) {
  std::error_code error;
  if (!std::filesystem::is_socket(path, error) || SomebodyListens(address)) return;
  std::filesystem::remove(path, error);
}

// Binding and the umask leave a group less than it may.
bool GivesGroupItsRight(const std::string& address) {
  return !IsUnixAddress(address) || chmod(PathOfUnix(address).c_str(), 0660) == 0;
}

std::string WhyNot(const std::string& address) {
  if (errno != EADDRINUSE) return std::strerror(errno);
  if (!IsUnixAddress(address)) return "the port is in use";
  std::error_code error;
  return std::filesystem::is_socket(PathOfUnix(address), error)
             ? "the socket is in use by another server"
             : "there is something else than a socket";
}

}  // namespace

ListeningSocket::ListeningSocket(const std::string& address) : address_(address) {
  const bool local = IsUnixAddress(address);
  const SocketAddress to = local ? UnixSocketAddress(PathOfUnix(address)) : Resolve(address);
  fd_ = FileDescriptor(socket(to.family(), SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!fd_) Fail(address, std::strerror(errno));
  if (local) {
    RemoveStale(PathOfUnix(address), to);
    fchmod(fd(), 0660);  // before others see it
  } else {
    Switch(fd(), SOL_SOCKET, SO_REUSEADDR, 1);
    Switch(fd(), IPPROTO_TCP, TCP_NODELAY, 1);  // what is accepted inherits it
    if (to.family() == AF_INET6) Switch(fd(), IPPROTO_IPV6, IPV6_V6ONLY, 0);
  }
  if (bind(fd(), to.get(), to.size()) != 0 || !GivesGroupItsRight(address) ||
      listen(fd(), SOMAXCONN) != 0) {
    const std::string why = WhyNot(address);
    fd_.Close();  // else the destructor of another's file
    Fail(address, why);
  }
  if (!local) address_ = HostOf(address) + ":" + std::to_string(SocketAddress::Local(fd()).port());
}

ListeningSocket::~ListeningSocket() {
  if (fd_ && IsUnixAddress(address_)) unlink(PathOfUnix(address_).c_str());
}

}  // namespace fovea::server
