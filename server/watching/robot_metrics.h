// What is counted for each robot.
#pragma once

#include <prometheus/counter.h>
#include <prometheus/family.h>
#include <prometheus/histogram.h>
#include <prometheus/registry.h>

#include <chrono>
#include <cstddef>
#include <list>
#include <map>
#include <mutex>
#include <string>
#include <unordered_map>

namespace fovea::server {

// Thread-safe. A bounded number of robots has figures of its own, so that callers who invent names
// cannot fill the memory. A new one takes the place of the one that was not heard of for longest,
// once that is gone; until then it is counted as "other". A robot that comes back after it lost its
// place starts from 0 again, which Prometheus takes for a restart: rates stay right.
class RobotMetrics {
 public:
  // A robot is gone when it was not heard of for `gone_after`.
  RobotMetrics(prometheus::Registry& registry, std::size_t max_robots,
               std::chrono::nanoseconds gone_after);

  // An empty name belongs to nobody and is not counted.
  void OnReceived(const std::string& robot);
  void OnAnswered(const std::string& robot, const char* code);
  void OnAnswerTime(const std::string& robot, double seconds);
  void OnRefused(const std::string& robot);

 private:
  struct Figures {
    std::string name;
    std::chrono::steady_clock::time_point seen;
    prometheus::Counter* received = nullptr;
    prometheus::Counter* refused = nullptr;
    prometheus::Histogram* answer_times = nullptr;
    std::map<std::string, prometheus::Counter*> answered;  // by code
  };

  // mutex_ is held for all of these, and as long as their result is used.
  Figures& Of(const std::string& robot);
  Figures Make(const std::string& name);
  void Remove(const Figures& figures);
  bool IsGone(const Figures& figures) const;

  const std::size_t max_robots_;
  const std::chrono::nanoseconds gone_after_;
  prometheus::Family<prometheus::Counter>& received_;
  prometheus::Family<prometheus::Counter>& answered_;
  prometheus::Family<prometheus::Counter>& refused_;
  prometheus::Family<prometheus::Histogram>& answer_times_;

  std::mutex mutex_;
  std::list<Figures> robots_;  // last heard of first
  std::unordered_map<std::string, std::list<Figures>::iterator> by_name_;
  Figures others_;
};

}  // namespace fovea::server
