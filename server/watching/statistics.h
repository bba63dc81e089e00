#pragma once

#include <prometheus/metric_family.h>

#include <chrono>
#include <vector>

#include "fovea/v1/detection_service.pb.h"

namespace fovea::server {

// The same figures as a message, without what tells robots apart: any robot may ask.
v1::GetStatisticsResponse StatisticsOf(const std::vector<prometheus::MetricFamily>& families,
                                       std::chrono::nanoseconds uptime);

}  // namespace fovea::server
