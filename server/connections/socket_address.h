#pragma once

#include <sys/socket.h>

#include <cstdint>
#include <string>

namespace fovea::server {

// An IPv4, IPv6 or UNIX address.
class SocketAddress {
 public:
  SocketAddress(const sockaddr* address, socklen_t size);

  // Of this end of a socket, and of the other. Of no family where there is none (any more).
  static SocketAddress Local(int fd);
  static SocketAddress Remote(int fd);

  const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&storage_); }
  socklen_t size() const { return size_; }
  int family() const { return storage_.ss_family; }
  // 0 of a UNIX address.
  std::uint16_t port() const;

  // As gRPC's ServerContext::peer() writes it: "ipv4:10.0.0.7:41234", "ipv6:%5B::1%5D:41234";
  // "unix:" with the path, and the abstract name where it has one.
  std::string Uri() const;

  // How this machine reaches itself there: "127.0.0.1" for "0.0.0.0" and, mapped to IPv6, for
  // "[::]", since machines and containers whose IPv6 is switched off have that, but no "[::1]".
  SocketAddress OrLoopback() const;
  // The same host with any free port; any free name of a UNIX address.
  SocketAddress WithAnyPort() const;

 private:
  SocketAddress() = default;

  sockaddr_storage storage_{};
  socklen_t size_ = 0;
};

// Throws std::invalid_argument for a path that is too long (107 bytes).
SocketAddress UnixSocketAddress(const std::string& path);

bool IsUnixPeer(const std::string& uri);

// "ipv4:10.0.0.7" of "ipv4:10.0.0.7:41234", "unix" of any UNIX peer.
std::string AddressOfPeer(const std::string& uri);

// By whom it is counted what callers take: the same, but "ipv6:2001:db8::/64" of
// "ipv6:%5B2001:db8::7%5D:41234", since an IPv6 host may have all addresses of its /64; "ipv4:…" of
// one that is mapped to IPv6.
std::string HostOfPeer(const std::string& uri);

}  // namespace fovea::server
