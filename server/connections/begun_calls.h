// How many calls gRPC took in, also those that nobody here has seen yet: gRPC 1.51 queues calls
// without a bound, about 6 kB each, until the server asks for the next one.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace fovea::server {

struct CallsOfConnection {
  std::string peer;  // as ServerContext::peer()
  std::uint64_t begun = 0;
};

// Of all servers that there are in this process, since each began. Takes microseconds. Throws
// std::exception where gRPC does not tell.
std::uint64_t NumBegunCalls();

// Of each connection that is open, since it came. Takes some 20 us for each. Throws std::exception.
std::vector<CallsOfConnection> BegunCallsByConnection();

}  // namespace fovea::server
