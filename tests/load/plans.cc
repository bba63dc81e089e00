#include "tests/load/plans.h"

namespace fovea::load {

std::vector<RobotPlan> MakePlans(const Flags& flags, const v1::Frame& frame, Links* links) {
  const RobotPlan plan{
      .server = flags.server,
      .name = "",
      .role = "",
      .rate_hz = flags.rate_hz,
      .stream = flags.stream,
      .retry = flags.retry,
      .noted_from = std::chrono::steady_clock::now() + std::chrono::seconds(flags.warm_up),
      .frame = frame};
  std::vector<RobotPlan> plans(static_cast<std::size_t>(flags.robots), plan);
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
    add("slow").server = links->slow->Address();
  }
  if (flags.vanish) {
    links->vanishing.emplace(flags.server, 0);
    add("vanishes").server = links->vanishing->Address();
  }
  for (std::size_t i = 0; i < plans.size(); ++i) {
    plans[i].name = "robot-" + std::to_string(i);
    plans[i].phase = static_cast<double>(i) / static_cast<double>(plans.size());
    plans[i].frame.set_id(plans[i].name);
  }
  return plans;
}

}  // namespace fovea::load
