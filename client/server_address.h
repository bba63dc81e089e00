#pragma once

#include <string>
#include <vector>

namespace fovea::client {

// Where one server may be: a host and a port, or a UNIX socket.
struct ServerAddress {
  std::string host, port;  // the host is a name or a number, IPv6 without brackets
  std::string path;        // of the socket; else empty
};

// Of "HOST:PORT" (IPv6 in brackets), "unix:/PATH", or several of these with commas between them.
// "ipv4:", "ipv6:" and "dns:///" in front, as gRPC has them, are left out. Throws
// std::invalid_argument that says what is wrong with which one.
std::vector<ServerAddress> ParseServerAddresses(const std::string& text);

// What gRPC connects to.
struct ServerTarget {
  std::string target;     // "ipv4:10.0.0.1:50051", "ipv6:[::1]:50051", "unix:/run/fovea.sock"
  std::string authority;  // whom its certificate must name: "detector:50051"; empty = the target

  bool operator==(const ServerTarget&) const = default;
};

// All that these addresses stand for, each once. A name may stand for several; that takes as long
// as the system's resolver does. Where none is found, `problem` says why.
struct FoundTargets {
  std::vector<ServerTarget> targets;
  std::string problem;
};
FoundTargets FindTargets(const std::vector<ServerAddress>& addresses);

// Whether any of them has to be looked up.
bool HaveNames(const std::vector<ServerAddress>& addresses);

}  // namespace fovea::client
