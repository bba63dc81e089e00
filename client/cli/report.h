#pragma once

#include <string>

#include "fovea/v1/detection.pb.h"

namespace fovea::cli {

// What was found as a table for people, with what limited it where little was found.
// `round_trip_ms` is the time of the whole call.
std::string Report(const v1::Detections& detections, double round_trip_ms);

}  // namespace fovea::cli
