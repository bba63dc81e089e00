#include "client/server_address.h"

#include <arpa/inet.h>
#include <netdb.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <memory>
#include <stdexcept>
#include <string_view>

namespace fovea::client {
namespace {

constexpr std::string_view kUnix = "unix:";

bool IsPort(std::string_view port) {
  const char* const last = port.data() + port.size();
  int number = 0;
  const auto [end, error] = std::from_chars(port.data(), last, number);
  return error == std::errc{} && end == last && number >= 1 && number <= 65535;
}

bool IsOfFamily(int family, const std::string& host) {
  in6_addr number{};
  return inet_pton(family, host.c_str(), &number) == 1;
}

std::string_view WithoutScheme(std::string_view text) {
  for (const std::string_view scheme : {"dns:///", "dns:", "ipv4:", "ipv6:"}) {
    if (text.starts_with(scheme)) return text.substr(scheme.size());
  }
  return text;
}

// gRPC would say of it that it cannot create a channel.
void CheckSocketPath(const std::string& text, const std::string& path) {
  constexpr std::size_t kLongest = sizeof(sockaddr_un::sun_path) - 1;  // without the final zero
  if (path.size() <= kLongest) return;
  throw std::invalid_argument("\"" + text + "\": the path of a UNIX socket has at most " +
                              std::to_string(kLongest) + " bytes, this one has " +
                              std::to_string(path.size()));
}

ServerAddress ParseOne(const std::string& text) {
  if (text.starts_with(kUnix)) {
    ServerAddress address;
    address.path = text.substr(kUnix.size());
    if (address.path.starts_with("///")) address.path.erase(0, 2);
    CheckSocketPath(text, address.path);
    if (!address.path.empty()) return address;
  }
  const std::string_view rest = WithoutScheme(text);
  const std::size_t colon = rest.rfind(':');
  if (colon != std::string_view::npos && IsPort(rest.substr(colon + 1))) {
    std::string host(rest.substr(0, colon));
    const bool in_brackets = host.starts_with('[') && host.ends_with(']');
    if (in_brackets) host = host.substr(1, host.size() - 2);
    const bool is_host =
        in_brackets ? IsOfFamily(AF_INET6, host) : host.find_first_of("/ :[]") == std::string::npos;
    if (!host.empty() && is_host) {
      return {.host = std::move(host), .port = std::string(rest.substr(colon + 1)), .path = {}};
    }
  }
  throw std::invalid_argument("\"" + text +
                              "\" is not HOST:PORT with a port of 1 to 65535, for example "
                              "127.0.0.1:50051 or [::1]:50051, and not unix:/PATH");
}

bool IsName(const ServerAddress& address) {
  return address.path.empty() && !IsOfFamily(AF_INET, address.host) &&
         !IsOfFamily(AF_INET6, address.host);
}

std::string TargetOf(const sockaddr& address, socklen_t size, const std::string& port) {
  std::array<char, NI_MAXHOST> host{};
  if (getnameinfo(&address, size, host.data(), host.size(), nullptr, 0, NI_NUMERICHOST) != 0) {
    return {};
  }
  const std::string number = host.data();
  return address.sa_family == AF_INET6 ? "ipv6:[" + number + "]:" + port
                                       : "ipv4:" + number + ":" + port;
}

void LookUp(const ServerAddress& address, FoundTargets* found) {
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* list = nullptr;
  const int error = getaddrinfo(address.host.c_str(), nullptr, &wanted, &list);
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owner(list, &freeaddrinfo);
  if (error != 0) {
    found->problem = "cannot look up " + address.host + ": " + gai_strerror(error);
    return;
  }
  for (const addrinfo* each = list; each != nullptr; each = each->ai_next) {
    if (each->ai_family != AF_INET && each->ai_family != AF_INET6) continue;
    found->targets.push_back({TargetOf(*each->ai_addr, each->ai_addrlen, address.port),
                              address.host + ":" + address.port});
  }
}

}  // namespace

std::vector<ServerAddress> ParseServerAddresses(const std::string& text) {
  std::vector<ServerAddress> addresses;
  std::size_t first = 0;
  while (first <= text.size()) {
    const std::size_t comma = std::min(text.find(',', first), text.size());
    addresses.push_back(ParseOne(text.substr(first, comma - first)));
    first = comma + 1;
  }
  return addresses;
}

FoundTargets FindTargets(const std::vector<ServerAddress>& addresses) {
  FoundTargets all, found;
  for (const ServerAddress& address : addresses) {
    if (!address.path.empty()) {
      found.targets.push_back({"unix:" + address.path, "localhost"});
    } else if (IsName(address)) {
      LookUp(address, &found);
    } else if (IsOfFamily(AF_INET6, address.host)) {
      found.targets.push_back({"ipv6:[" + address.host + "]:" + address.port, {}});
    } else {
      found.targets.push_back({"ipv4:" + address.host + ":" + address.port, {}});
    }
  }
  all.problem = found.problem;
  for (const ServerTarget& each : found.targets) {
    if (std::ranges::find(all.targets, each.target, &ServerTarget::target) == all.targets.end()) {
      all.targets.push_back(each);
    }
  }
  return all;
}

bool HaveNames(const std::vector<ServerAddress>& addresses) {
  return std::ranges::any_of(addresses, IsName);
}

}  // namespace fovea::client
