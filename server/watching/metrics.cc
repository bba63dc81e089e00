#include "server/watching/metrics.h"

#include <utility>

#include "server/status.h"

namespace fovea::server {
namespace {

constexpr std::size_t kMaxRobots = 64;

auto& CounterFamily(prometheus::Registry& registry, const char* name, const char* help) {
  return prometheus::BuildCounter().Name(name).Help(help).Register(registry);
}

auto& Counter(prometheus::Registry& registry, const char* name, const char* help) {
  return CounterFamily(registry, name, help).Add({});
}

auto& Gauge(prometheus::Registry& registry, const char* name, const char* help) {
  return prometheus::BuildGauge().Name(name).Help(help).Register(registry).Add({});
}

// Seconds; a refusal costs no computing, so these are short unless the processors are taken.
const prometheus::Histogram::BucketBoundaries& RefusalBuckets() {
  static const prometheus::Histogram::BucketBoundaries buckets{0.0001, 0.0002, 0.0005, 0.001, 0.002,
                                                               0.005,  0.01,   0.02,   0.05,  0.1};
  return buckets;
}

// Seconds; from a decoded JPEG to a frame that waited long.
const prometheus::Histogram::BucketBoundaries& Buckets() {
  static const prometheus::Histogram::BucketBoundaries buckets{
      0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10};
  return buckets;
}

}  // namespace

Metrics::Metrics(std::function<std::size_t()> num_waiting)
    : num_waiting_(std::move(num_waiting)),
      received_(CounterFamily(registry_, "fovea_frames_received_total",
                              "Frames that came in, by robot; those beyond 64 are \"other\"")),
      answered_(CounterFamily(registry_, "fovea_frames_answered_total",
                              "Frames with an answer, by its status code")),
      refused_(CounterFamily(registry_, "fovea_refused_total",
                             "Calls and streams that were not let in, or were given up before "
                             "their turn, by reason: a limit, else the status code")),
      dropped_(Counter(registry_, "fovea_frames_dropped_total",
                       "Frames of streams that a newer one took the place of")),
      objects_(Counter(registry_, "fovea_objects_total", "Objects detected")),
      bytes_received_(Counter(registry_, "fovea_received_bytes_total", "Size of all requests")),
      bytes_sent_(Counter(registry_, "fovea_sent_bytes_total", "Size of all answers")),
      streams_(Gauge(registry_, "fovea_streams", "Streams that are open")),
      waiting_(Gauge(registry_, "fovea_frames_waiting", "Frames that wait for a compute thread")),
      turning_away_(prometheus::BuildHistogram()
                        .Name("fovea_refusal_seconds")
                        .Help("Time from the arrival of a call that found no room until its "
                              "refusal was sent")
                        .Register(registry_)
                        .Add({}, RefusalBuckets())),
      stages_(prometheus::BuildHistogram()
                  .Name("fovea_stage_seconds")
                  .Help("Time that a frame spent in each stage, waiting (queue) included")
                  .Register(registry_)) {}

void Metrics::OnReceived(const std::string& robot) { OfRobot(robot).Increment(); }

void Metrics::OnReceivedBytes(std::size_t bytes) {
  bytes_received_.Increment(static_cast<double>(bytes));
}

void Metrics::OnDropped() { dropped_.Increment(); }

void Metrics::OnAnswered(const grpc::Status& status, const Detections& detections) {
  answered_.Add({{"code", NameOf(status.error_code())}}).Increment();
  objects_.Increment(static_cast<double>(detections.objects.size()));
  for (const StageTime& time : detections.stage_times) {
    stages_.Add({{"stage", time.stage}}, Buckets()).Observe(time.duration_ms / 1000);
  }
}

void Metrics::OnRefused(const char* reason) { refused_.Add({{"reason", reason}}).Increment(); }

void Metrics::OnTurnedAway(std::chrono::nanoseconds took) {
  turning_away_.Observe(std::chrono::duration<double>(took).count());
}

void Metrics::OnSent(std::size_t bytes) { bytes_sent_.Increment(static_cast<double>(bytes)); }

void Metrics::OnStreams(int change) { streams_.Increment(change); }

std::vector<prometheus::MetricFamily> Metrics::Collect() const {
  waiting_.Set(static_cast<double>(num_waiting_()));
  return registry_.Collect();
}

prometheus::Counter& Metrics::OfRobot(const std::string& robot) {
  const std::lock_guard lock(mutex_);
  if (robots_.size() < kMaxRobots) robots_.insert(robot);
  return received_.Add({{"robot", robots_.contains(robot) ? robot : "other"}});
}

}  // namespace fovea::server
