#include "server/connections/socket_address.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <spdlog/fmt/fmt.h>
#include <sys/un.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <stdexcept>
#include <string_view>

namespace fovea::server {
namespace {

constexpr std::size_t kMappedPrefix = 12;  // bytes before an IPv4 address that is mapped to IPv6

template <typename Address>
const Address& As(const sockaddr_storage& storage) {
  return reinterpret_cast<const Address&>(storage);
}

template <typename Address>
Address& As(sockaddr_storage& storage) {
  return reinterpret_cast<Address&>(storage);
}

std::string Text(int family, const void* host) {
  std::array<char, INET6_ADDRSTRLEN> text{};
  inet_ntop(family, host, text.data(), text.size());
  return text.data();
}

std::string Ipv6Uri(const sockaddr_in6& address) {
  const int port = ntohs(address.sin6_port);
  if (IN6_IS_ADDR_V4MAPPED(&address.sin6_addr)) {  // an IPv4 caller of a socket for both
    return fmt::format("ipv4:{}:{}", Text(AF_INET, address.sin6_addr.s6_addr + kMappedPrefix),
                       port);
  }
  std::string host = Text(AF_INET6, &address.sin6_addr);
  if (address.sin6_scope_id != 0) host += fmt::format("%25{}", address.sin6_scope_id);
  return fmt::format("ipv6:%5B{}%5D:{}", host, port);
}

// "ipv6:2001:db8::/64" of "ipv6:%5B2001:db8::7%5D", whether the brackets are escaped or not. What
// is no address is left as it is, and so is this machine's own.
std::string NetworkOf(const std::string& uri) {
  constexpr std::string_view kEscaped = "ipv6:%5B", kPlain = "ipv6:[";
  const std::size_t begin = uri.starts_with(kEscaped) ? kEscaped.size() : kPlain.size();
  const std::size_t end = std::min(uri.find_first_of("%]", begin), uri.size());
  in6_addr address{};
  const bool known =
      begin < end && inet_pton(AF_INET6, uri.substr(begin, end - begin).c_str(), &address) == 1;
  if (!known || IN6_IS_ADDR_LOOPBACK(&address)) return uri;
  if (IN6_IS_ADDR_V4MAPPED(&address)) {
    return "ipv4:" + Text(AF_INET, address.s6_addr + kMappedPrefix);
  }
  std::fill(address.s6_addr + 8, std::end(address.s6_addr), std::uint8_t{0});
  return fmt::format("ipv6:{}/64", Text(AF_INET6, &address));
}

}  // namespace

SocketAddress::SocketAddress(const sockaddr* address, socklen_t size)
    : size_(std::min<socklen_t>(size, sizeof storage_)) {
  std::memcpy(&storage_, address, size_);
}

SocketAddress SocketAddress::Local(int fd) {
  SocketAddress address;
  address.size_ = sizeof address.storage_;
  getsockname(fd, reinterpret_cast<sockaddr*>(&address.storage_), &address.size_);
  return address;
}

SocketAddress SocketAddress::Remote(int fd) {
  SocketAddress address;
  address.size_ = sizeof address.storage_;
  getpeername(fd, reinterpret_cast<sockaddr*>(&address.storage_), &address.size_);
  return address;
}

std::uint16_t SocketAddress::port() const {
  if (family() == AF_INET) return ntohs(As<sockaddr_in>(storage_).sin_port);
  if (family() == AF_INET6) return ntohs(As<sockaddr_in6>(storage_).sin6_port);
  return 0;
}

std::string SocketAddress::Uri() const {
  if (family() == AF_INET) {
    return fmt::format("ipv4:{}:{}", Text(AF_INET, &As<sockaddr_in>(storage_).sin_addr), port());
  }
  if (family() == AF_INET6) return Ipv6Uri(As<sockaddr_in6>(storage_));
  const std::size_t path = offsetof(sockaddr_un, sun_path);
  const auto& address = As<sockaddr_un>(storage_);
  std::string uri = "unix:";
  if (size_ > path) uri.append(address.sun_path, size_ - path);
  return uri;
}

SocketAddress SocketAddress::OrLoopback() const {
  SocketAddress address = *this;
  if (family() == AF_INET) {
    auto& host = As<sockaddr_in>(address.storage_).sin_addr.s_addr;
    if (host == htonl(INADDR_ANY)) host = htonl(INADDR_LOOPBACK);
  } else if (family() == AF_INET6) {
    auto& host = As<sockaddr_in6>(address.storage_).sin6_addr;
    if (IN6_IS_ADDR_UNSPECIFIED(&host)) inet_pton(AF_INET6, "::ffff:127.0.0.1", &host);
  }
  return address;
}

SocketAddress SocketAddress::WithAnyPort() const {
  SocketAddress address = *this;
  if (family() == AF_INET) As<sockaddr_in>(address.storage_).sin_port = 0;
  if (family() == AF_INET6) As<sockaddr_in6>(address.storage_).sin6_port = 0;
  if (family() == AF_UNIX) address.size_ = offsetof(sockaddr_un, sun_path);
  return address;
}

SocketAddress UnixSocketAddress(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) {
    throw std::invalid_argument("--listen: \"unix:" + path + "\" has a path of more than " +
                                std::to_string(sizeof address.sun_path - 1) + " bytes");
  }
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  const std::size_t size = offsetof(sockaddr_un, sun_path) + path.size() + 1;
  return {reinterpret_cast<const sockaddr*>(&address), static_cast<socklen_t>(size)};
}

bool IsUnixPeer(const std::string& uri) { return uri.starts_with("unix"); }

std::string AddressOfPeer(const std::string& uri) {
  return IsUnixPeer(uri) ? "unix" : uri.substr(0, uri.rfind(':'));
}

std::string HostOfPeer(const std::string& uri) {
  const std::string address = AddressOfPeer(uri);
  return address.starts_with("ipv6:") ? NetworkOf(address) : address;
}

}  // namespace fovea::server
