#pragma once

#include <compare>
#include <string>

namespace fovea::server {

// Whose turn it is. Turns and places are shared between groups first, then between the robots of
// one: names that nobody vouches for are free, so that more names shall get a host no more.
struct RobotId {
  // The robot itself where a token or a certificate says who it is, else the host that calls.
  std::string group;
  std::string name;

  // NOLINTNEXTLINE(modernize-use-nullptr): of the 0 that comparisons are made with
  auto operator<=>(const RobotId&) const = default;
};

}  // namespace fovea::server
