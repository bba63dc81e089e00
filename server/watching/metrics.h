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
#include <set>
#include <string>
#include <vector>

#include "core/types/detections.h"

namespace fovea::server {

// Thread-safe. Robots beyond the first 64 are counted as "other", so that callers who invent names
// cannot fill the memory.
class Metrics : public prometheus::Collectable {
 public:
  // `num_waiting` tells how many frames wait at the moment.
  explicit Metrics(std::function<std::size_t()> num_waiting);

  // A frame, or the call that would bring it if it were let in.
  void OnReceived(const std::string& robot);
  void OnReceivedBytes(std::size_t bytes);
  void OnDropped();
  // Whatever became of it; `detections` is empty where the status is not OK.
  void OnAnswered(const grpc::Status& status, const Detections& detections);
  // A call or a stream that was not let in, or was given up before its turn. `reason` is one of
  // few.
  void OnRefused(const char* reason);
  // A call that found no room, `took` after it came.
  void OnTurnedAway(std::chrono::nanoseconds took);
  void OnSent(std::size_t bytes);
  void OnStreams(int change);

  std::vector<prometheus::MetricFamily> Collect() const override;

 private:
  prometheus::Counter& OfRobot(const std::string& robot);

  const std::function<std::size_t()> num_waiting_;
  prometheus::Registry registry_;
  prometheus::Family<prometheus::Counter>& received_;  // by robot
  prometheus::Family<prometheus::Counter>& answered_;  // by status code
  prometheus::Family<prometheus::Counter>& refused_;   // by reason
  prometheus::Counter& dropped_;
  prometheus::Counter& objects_;
  prometheus::Counter& bytes_received_;
  prometheus::Counter& bytes_sent_;
  prometheus::Gauge& streams_;
  prometheus::Gauge& waiting_;
  prometheus::Histogram& turning_away_;
  prometheus::Family<prometheus::Histogram>& stages_;  // "queue" and "decode" included

  std::mutex mutex_;
  std::set<std::string> robots_;
};

}  // namespace fovea::server
