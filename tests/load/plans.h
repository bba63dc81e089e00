// Which robots there are, as the flags want them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/load/robot.h"
#include "tests/load/slow_link.h"

namespace fovea::load {

struct Flags {
  std::string server = "127.0.0.1:50051", kind = "tabletop";
  std::vector<int> hold;  // robots at each of the servers; empty = the client chooses
  std::vector<int> size_px = {640, 480};
  int robots = 1, warm_up = 3, seconds = 20, saboteurs = 0, pid = 0;
  int greedy_calls = 0, slow_kb_per_s = 0;
  double rate_hz = 0, greedy = 1;
  bool turns = false, stream = false, retry = false, vanish = false;
};

// The ways of those that have a special one.
struct Links {
  std::optional<SlowLink> slow, vanishing;
};

// Of ordinary robots and of those that are special, without the time from which they are noted.
// `links` must live as long as they do. Throws std::invalid_argument for flags that do not fit
// together.
std::vector<RobotPlan> MakePlans(const Flags& flags, const v1::Frame& frame, Links* links);

}  // namespace fovea::load
