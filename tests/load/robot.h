// A simulated robot: sends frames at its rate and notes what becomes of them.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include "fovea/v1/frame.pb.h"

namespace fovea::load {

struct RobotPlan {
  std::vector<std::string> servers;  // addresses that are asked in turns, a client for each
  std::string name, role;
  double rate_hz = 0;  // 0 = the next frame as soon as the last one is answered
  double phase = 0;    // of the first frame, as a share of the time between two
  bool stream = false;
  int calls_at_once = 1;  // each repeated as soon as it is answered, or as the server says
  bool retry = false;     // repeats refused calls, and resumes streams, as the library does
  // What was sent earlier is not noted: everybody connects at once, and the server's memory is new.
  std::chrono::steady_clock::time_point noted_from;
  v1::Frame frame;
};

struct Outcome {
  std::string role;  // what is special about it; empty = nothing
  std::uint64_t sent = 0, dropped = 0, lost = 0;
  std::vector<double> latency_ms;               // of each detection
  std::vector<double> overhead_ms;              // what of that is neither queue nor computing
  std::vector<double> refusal_ms;               // until each call that failed did
  std::map<std::string, std::uint64_t> errors;  // by the name of the status code
};

// Of several together.
Outcome Sum(const std::vector<Outcome>& outcomes);

// Returns once every server that they ask serves; throws what client::Client does where one cannot
// be asked, or does not serve in time.
void WaitForServers(const std::vector<RobotPlan>& plans);

// Until it is told to stop.
Outcome RunRobot(const RobotPlan& plan, const std::stop_token& stop);

}  // namespace fovea::load
