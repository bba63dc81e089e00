#include "server/watching/statistics.h"

#include <google/protobuf/util/time_util.h>

#include <cmath>
#include <cstdint>

namespace fovea::server {
namespace {

using google::protobuf::util::TimeUtil;
using prometheus::ClientMetric;
using prometheus::MetricFamily;

// Counters and gauges count in doubles.
std::uint64_t Whole(double value) { return static_cast<std::uint64_t>(std::llround(value)); }

std::uint64_t SumOf(const MetricFamily& family) {
  double sum = 0;
  for (const ClientMetric& metric : family.metric) sum += metric.counter.value + metric.gauge.value;
  return Whole(sum);
}

// Every family here has at most one label.
const std::string& LabelOf(const ClientMetric& metric) { return metric.label.front().value; }

void AddStages(const MetricFamily& family, v1::GetStatisticsResponse* response) {
  for (const ClientMetric& metric : family.metric) {
    v1::StageStatistics& stage = (*response->mutable_stages())[LabelOf(metric)];
    stage.set_count(metric.histogram.sample_count);
    *stage.mutable_total() =
        TimeUtil::NanosecondsToDuration(std::llround(metric.histogram.sample_sum * 1e9));
  }
}

void Add(const MetricFamily& family, v1::GetStatisticsResponse* response) {
  const std::string& name = family.name;
  if (name == "fovea_frames_received_total") response->set_frames_received(SumOf(family));
  if (name == "fovea_frames_dropped_total") response->set_frames_dropped(SumOf(family));
  if (name == "fovea_frames_waiting") response->set_frames_waiting(SumOf(family));
  if (name == "fovea_objects_total") response->set_objects(SumOf(family));
  if (name == "fovea_streams") response->set_streams(SumOf(family));
  if (name == "fovea_received_bytes_total") response->set_received_bytes(SumOf(family));
  if (name == "fovea_sent_bytes_total") response->set_sent_bytes(SumOf(family));
  if (name == "fovea_stage_seconds") AddStages(family, response);
  if (name == "fovea_frames_answered_total") {
    for (const ClientMetric& metric : family.metric) {
      const std::uint64_t count = Whole(metric.counter.value);
      if (count > 0) (*response->mutable_frames_answered())[LabelOf(metric)] = count;
    }
  }
}

}  // namespace

v1::GetStatisticsResponse StatisticsOf(const std::vector<MetricFamily>& families,
                                       std::chrono::nanoseconds uptime) {
  v1::GetStatisticsResponse response;
  *response.mutable_uptime() = TimeUtil::NanosecondsToDuration(uptime.count());
  for (const MetricFamily& family : families) Add(family, &response);
  return response;
}

}  // namespace fovea::server
