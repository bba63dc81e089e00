#include "server/watching/robot_metrics.h"

#include <spdlog/fmt/fmt.h>

#include <string_view>
#include <utility>

#include "server/logging/log_record.h"
#include "server/watching/metric_kinds.h"

namespace fovea::server {
namespace {

using Clock = std::chrono::steady_clock;

// Seconds; few, since every robot has them.
const prometheus::Histogram::BucketBoundaries& RobotBuckets() {
  static const prometheus::Histogram::BucketBoundaries buckets{0.05, 0.1, 0.2, 0.5, 1, 2, 5};
  return buckets;
}

// Labels are UTF-8, names from certificates may hold anything: bytes that are none, and control
// characters, become "\xE9", so that names that differ in them stay apart.
std::string Printable(std::string_view name) {
  std::string printable;
  while (!name.empty()) {
    const std::size_t length = LengthOfCharacter(name);
    const auto first = static_cast<unsigned char>(name.front());
    if (length == 0 || first < ' ' || first == 0x7F) {
      printable += fmt::format("\\x{:02X}", first);
      name.remove_prefix(1);
    } else {
      printable += name.substr(0, length);
      name.remove_prefix(length);
    }
  }
  return printable;
}

}  // namespace

RobotMetrics::RobotMetrics(prometheus::Registry& registry, std::size_t max_robots,
                           std::chrono::nanoseconds gone_after)
    : max_robots_(max_robots),
      gone_after_(gone_after),
      received_(CounterFamily(registry, "fovea_robot_frames_received_total",
                              "Frames that came in, by robot; \"other\" are those beyond 64")),
      answered_(CounterFamily(registry, "fovea_robot_frames_answered_total",
                              "Frames with an answer, by robot and status code")),
      refused_(CounterFamily(registry, "fovea_robot_refused_total",
                             "Calls and streams that were not let in, or were given up before "
                             "their turn, by robot")),
      answer_times_(prometheus::BuildHistogram()
                        .Name("fovea_robot_answer_seconds")
                        .Help("Time from the receipt of a frame to its answer, by robot")
                        .Register(registry)) {
  others_.name = "other";
}

void RobotMetrics::OnReceived(const std::string& robot) {
  if (robot.empty()) return;
  const std::lock_guard lock(mutex_);
  Of(robot).received->Increment();
}

void RobotMetrics::OnAnswered(const std::string& robot, const char* code) {
  if (robot.empty()) return;
  const std::lock_guard lock(mutex_);
  Figures& figures = Of(robot);
  prometheus::Counter*& counter = figures.answered[code];
  if (counter == nullptr) counter = &answered_.Add({{"robot", figures.name}, {"code", code}});
  counter->Increment();
}

void RobotMetrics::OnAnswerTime(const std::string& robot, double seconds) {
  if (robot.empty()) return;
  const std::lock_guard lock(mutex_);
  Of(robot).answer_times->Observe(seconds);
}

void RobotMetrics::OnRefused(const std::string& robot) {
  if (robot.empty()) return;
  const std::lock_guard lock(mutex_);
  Of(robot).refused->Increment();
}

RobotMetrics::Figures& RobotMetrics::Of(const std::string& robot) {
  const std::string name = Printable(robot);
  if (const auto found = by_name_.find(name); found != by_name_.end()) {
    robots_.splice(robots_.begin(), robots_, found->second);
    robots_.front().seen = Clock::now();
    return robots_.front();
  }
  const bool full = robots_.size() >= max_robots_;
  if (name == others_.name || (full && !IsGone(robots_.back()))) {
    if (others_.received == nullptr) others_ = Make(others_.name);
    return others_;
  }
  if (full) {
    Remove(robots_.back());
    by_name_.erase(robots_.back().name);
    robots_.pop_back();
  }
  robots_.push_front(Make(name));
  by_name_.emplace(name, robots_.begin());
  return robots_.front();
}

RobotMetrics::Figures RobotMetrics::Make(const std::string& name) {
  const prometheus::Labels labels{{"robot", name}};
  return {.name = name,
          .seen = Clock::now(),
          .received = &received_.Add(labels),
          .refused = &refused_.Add(labels),
          .answer_times = &answer_times_.Add(labels, RobotBuckets()),
          .answered = {}};
}

void RobotMetrics::Remove(const Figures& figures) {
  received_.Remove(figures.received);
  refused_.Remove(figures.refused);
  answer_times_.Remove(figures.answer_times);
  for (const auto& [code, counter] : figures.answered) answered_.Remove(counter);
}

bool RobotMetrics::IsGone(const Figures& figures) const {
  return Clock::now() - figures.seen >= gone_after_;
}

}  // namespace fovea::server
