#include "server/watching/metrics.h"

#include <utility>

#include "server/build_info.h"
#include "server/scheduling/refusal_reasons.h"
#include "server/status.h"
#include "server/watching/metric_kinds.h"

namespace fovea::server {
namespace {

constexpr std::size_t kMaxRobots = 64;

auto& Counter(prometheus::Registry& registry, const char* name, const char* help) {
  return CounterFamily(registry, name, help).Add({});
}

auto& Gauge(prometheus::Registry& registry, const char* name, const char* help) {
  return prometheus::BuildGauge().Name(name).Help(help).Register(registry).Add({});
}

auto& Histogram(prometheus::Registry& registry, const char* name, const char* help,
                const prometheus::Histogram::BucketBoundaries& buckets) {
  return prometheus::BuildHistogram().Name(name).Help(help).Register(registry).Add({}, buckets);
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

Metrics::Metrics(std::chrono::nanoseconds gone_after)
    : received_(Counter(registry_, "fovea_frames_received_total", "Frames that came in")),
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
      untaken_(Counter(registry_, "fovea_untaken_answers_total",
                       "Answers that were not taken in time, or while too many waited, which ended "
                       "their calls")),
      streams_(Gauge(registry_, "fovea_streams", "Streams that are open")),
      turning_away_(Histogram(registry_, "fovea_refusal_seconds",
                              "Time from the arrival of a call that found no room until its "
                              "refusal was sent",
                              RefusalBuckets())),
      answer_times_(Histogram(registry_, "fovea_answer_seconds",
                              "Time from the receipt of a frame until its answer was ready, of "
                              "those answered with OK",
                              Buckets())),
      stages_(prometheus::BuildHistogram()
                  .Name("fovea_stage_seconds")
                  .Help("Time that a frame spent in each stage, waiting (queue) included")
                  .Register(registry_)),
      robots_(registry_, kMaxRobots, gone_after) {
  // What has not happened yet is 0, not absent: else the first error is no increase.
  for (int code = 0; code <= grpc::StatusCode::UNAUTHENTICATED; ++code) {
    answered_.Add({{"code", NameOf(static_cast<grpc::StatusCode>(code))}});
  }
  for (const char* reason : kRefusalReasons) refused_.Add({{"reason", reason}});
  prometheus::BuildGauge()
      .Name("fovea_build_info")
      .Help("1; its labels say what this server is")
      .Register(registry_)
      .Add({{"version", Version()}, {"commit", Commit()}})
      .Set(1);
}

void Metrics::AddGauge(std::string name, std::string help, std::function<double()> value) {
  Add({std::move(name), std::move(help), prometheus::MetricType::Gauge, std::move(value)});
}

void Metrics::AddCounter(std::string name, std::string help, std::function<double()> value) {
  Add({std::move(name), std::move(help), prometheus::MetricType::Counter, std::move(value)});
}

void Metrics::Add(Reading reading) {
  const std::lock_guard lock(mutex_);
  readings_.push_back(std::move(reading));
}

void Metrics::OnReceived(const std::string& robot) {
  received_.Increment();
  robots_.OnReceived(robot);
}

void Metrics::OnReceivedBytes(std::size_t bytes) {
  bytes_received_.Increment(static_cast<double>(bytes));
}

void Metrics::OnDropped() { dropped_.Increment(); }

void Metrics::OnAnswered(const std::string& robot, const grpc::Status& status,
                         const Detections& detections, std::chrono::nanoseconds took) {
  const char* code = NameOf(status.error_code());
  answered_.Add({{"code", code}}).Increment();
  robots_.OnAnswered(robot, code);
  if (!status.ok()) return;  // a quick refusal is no quick answer, a stage cut off no quick one
  objects_.Increment(static_cast<double>(detections.objects.size()));
  for (const StageTime& time : detections.stage_times) {
    stages_.Add({{"stage", time.stage}}, Buckets()).Observe(time.duration_ms / 1000);
  }
  const double seconds = std::chrono::duration<double>(took).count();
  answer_times_.Observe(seconds);
  robots_.OnAnswerTime(robot, seconds);
}

void Metrics::OnRefused(const std::string& robot, const char* reason) {
  refused_.Add({{"reason", reason}}).Increment();
  robots_.OnRefused(robot);
}

void Metrics::OnTurnedAway(std::chrono::nanoseconds took) {
  turning_away_.Observe(std::chrono::duration<double>(took).count());
}

void Metrics::OnSent(std::size_t bytes) { bytes_sent_.Increment(static_cast<double>(bytes)); }

void Metrics::OnUntaken() { untaken_.Increment(); }

void Metrics::OnStreams(int change) { streams_.Increment(change); }

std::vector<prometheus::MetricFamily> Metrics::Collect() const {
  std::vector<prometheus::MetricFamily> families = registry_.Collect();
  const std::lock_guard lock(mutex_);
  for (const Reading& reading : readings_) {
    families.push_back(SingleMetric(reading.name, reading.help, reading.type, reading.value()));
  }
  for (prometheus::MetricFamily& family : process_.Collect()) families.push_back(std::move(family));
  return families;
}

}  // namespace fovea::server
