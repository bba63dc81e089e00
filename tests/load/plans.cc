#include "tests/load/plans.h"

#include <numeric>
#include <sstream>
#include <stdexcept>

namespace fovea::load {
namespace {

std::vector<std::string> ServersOf(const std::string& list) {
  std::vector<std::string> servers;
  std::istringstream rest(list);
  for (std::string one; std::getline(rest, one, ',');) servers.push_back(one);
  return servers;
}

void Check(const Flags& flags, std::size_t num_servers) {
  if (!flags.hold.empty() &&
      (flags.turns || flags.hold.size() != num_servers ||
       std::accumulate(flags.hold.begin(), flags.hold.end(), 0) != flags.robots)) {
    throw std::invalid_argument("--hold must have a number for each of the " +
                                std::to_string(num_servers) +
                                " servers, which together are --robots, and be without --turns");
  }
  if (num_servers > 1 && (flags.slow_kb_per_s > 0 || flags.vanish || flags.saboteurs > 0)) {
    throw std::invalid_argument(
        "--slow-link, --vanish and --saboteurs must be without a list of servers");
  }
}

// Which the robots ask that make no choice of their own.
void Hold(const Flags& flags, const std::vector<std::string>& servers,
          std::vector<RobotPlan>* plans) {
  auto plan = plans->begin();
  for (std::size_t i = 0; i < flags.hold.size(); ++i) {
    for (int robot = 0; robot < flags.hold[i]; ++robot) (plan++)->servers = {servers[i]};
  }
  if (!flags.turns) return;
  for (std::size_t i = 0; i < plans->size(); ++i) {
    (*plans)[i].servers = flags.stream ? std::vector{servers[i % servers.size()]} : servers;
  }
}

}  // namespace

std::vector<RobotPlan> MakePlans(const Flags& flags, const v1::Frame& frame, Links* links) {
  const RobotPlan plan{.servers = {flags.server},
                       .name = "",
                       .role = "",
                       .rate_hz = flags.rate_hz,
                       .stream = flags.stream,
                       .retry = flags.retry,
                       .noted_from = {},
                       .frame = frame};
  std::vector<RobotPlan> plans(static_cast<std::size_t>(flags.robots), plan);
  const std::vector<std::string> servers = ServersOf(flags.server);
  Check(flags, servers.size());
  Hold(flags, servers, &plans);
  if (flags.greedy > 1) {
    plans[0].rate_hz *= flags.greedy;
    plans[0].role = "often";
  }
  const auto add = [&](const char* role) -> RobotPlan& {
    plans.push_back(plan);
    plans.back().role = role;
    return plans.back();
  };
  if (flags.greedy_calls > 0) {
    RobotPlan& greedy = add("greedy");
    greedy.calls_at_once = flags.greedy_calls;
    greedy.rate_hz = 0;
    greedy.stream = greedy.retry = false;
  }
  if (flags.slow_kb_per_s > 0) {
    constexpr std::size_t kBytesPerKb = 1000;
    links->slow.emplace(flags.server, kBytesPerKb * static_cast<std::size_t>(flags.slow_kb_per_s));
    add("slow").servers = {links->slow->Address()};
  }
  if (flags.vanish) {
    links->vanishing.emplace(flags.server, 0);
    add("vanishes").servers = {links->vanishing->Address()};
  }
  for (std::size_t i = 0; i < plans.size(); ++i) {
    plans[i].name = "robot-" + std::to_string(i);
    plans[i].phase = static_cast<double>(i) / static_cast<double>(plans.size());
    plans[i].frame.set_id(plans[i].name);
  }
  return plans;
}

}  // namespace fovea::load
