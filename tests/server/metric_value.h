#pragma once

#include <algorithm>
#include <string>
#include <thread>

#include "server/watching/metrics.h"

namespace fovea::testing {

// Of the gauge or counter `name`, or what the histogram counted, summed over its labels, or over
// those with one of this value.
inline double MetricValue(const server::Metrics& metrics, const std::string& name,
                          const std::string& label = "") {
  double sum = 0;
  for (const auto& family : metrics.Collect()) {
    if (family.name != name) continue;
    for (const auto& metric : family.metric) {
      const bool wanted = std::any_of(metric.label.begin(), metric.label.end(),
                                      [&](const auto& each) { return each.value == label; });
      if (!label.empty() && !wanted) continue;
      sum += metric.gauge.value + metric.counter.value +
             static_cast<double>(metric.histogram.sample_count);
    }
  }
  return sum;
}

// Returns once it has that value; a hang means that it never does. It asks the server's memory:
// calls as fast as this would be taken for a flood, and their connection ended.
inline void AwaitMetric(const server::Metrics& metrics, const std::string& name, double value) {
  while (MetricValue(metrics, name) != value) std::this_thread::yield();
}

}  // namespace fovea::testing
