// What an operator wants to count. Served in Prometheus' format and by GetStatistics.
#pragma once

#include <grpcpp/support/status.h>
#include <prometheus/collectable.h>
#include <prometheus/counter.h>
#include <prometheus/family.h>
#include <prometheus/gauge.h>
#include <prometheus/histogram.h>
#include <prometheus/registry.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "core/types/detections.h"
#include "server/watching/process_metrics.h"
#include "server/watching/robot_metrics.h"

namespace fovea::server {

// Thread-safe. 64 robots have figures of their own, see RobotMetrics; the other figures are of all
// robots, whatever becomes of those.
class Metrics : public prometheus::Collectable {
 public:
  // A robot makes room for others when nothing was heard of it for `gone_after`.
  explicit Metrics(std::chrono::nanoseconds gone_after = std::chrono::seconds(10));

  // A value that is read when it is asked for: `value` is called from any thread, and must be valid
  // as long as this. Names of counters end in "_total".
  void AddGauge(std::string name, std::string help, std::function<double()> value);
  void AddCounter(std::string name, std::string help, std::function<double()> value);

  // A frame, or the call that would bring it if it were let in.
  void OnReceived(const std::string& robot);
  void OnReceivedBytes(std::size_t bytes);
  void OnDropped();
  // Whatever became of it, `took` after it came; `detections` counts where the status is OK.
  void OnAnswered(const std::string& robot, const grpc::Status& status,
                  const Detections& detections, std::chrono::nanoseconds took);
  // A call or a stream that was not let in, or was given up before its turn. `reason` is one of
  // few.
  void OnRefused(const std::string& robot, const char* reason);
  // A call that found no room, `took` after it came.
  void OnTurnedAway(std::chrono::nanoseconds took);
  void OnSent(std::size_t bytes);
  // An answer that its caller did not take, which ended the call.
  void OnUntaken();
  void OnStreams(int change);

  std::vector<prometheus::MetricFamily> Collect() const override;

 private:
  struct Reading {
    std::string name, help;
    prometheus::MetricType type;
    std::function<double()> value;
  };

  void Add(Reading reading);

  prometheus::Registry registry_;
  prometheus::Counter& received_;
  prometheus::Family<prometheus::Counter>& answered_;  // by status code
  prometheus::Family<prometheus::Counter>& refused_;   // by reason
  prometheus::Counter& dropped_;
  prometheus::Counter& objects_;
  prometheus::Counter& bytes_received_;
  prometheus::Counter& bytes_sent_;
  prometheus::Counter& untaken_;
  prometheus::Gauge& streams_;
  prometheus::Histogram& turning_away_;
  prometheus::Histogram& answer_times_;
  prometheus::Family<prometheus::Histogram>& stages_;  // "queue" and "decode" included
  RobotMetrics robots_;

  mutable std::mutex mutex_;
  std::vector<Reading> readings_;
  ProcessMetrics process_;
};

}  // namespace fovea::server
