#pragma once

#include <prometheus/metric_family.h>

#include <string>

namespace fovea::server {

// A gauge or counter that is read when it is asked for.
inline prometheus::MetricFamily SingleMetric(const std::string& name, const std::string& help,
                                             prometheus::MetricType type, double value) {
  prometheus::ClientMetric metric;
  (type == prometheus::MetricType::Counter ? metric.counter.value : metric.gauge.value) = value;
  return {.name = name, .help = help, .type = type, .metric = {metric}};
}

}  // namespace fovea::server
