#pragma once

#include <string>

#include "fovea/v1/detection.pb.h"

namespace fovea::cli {

// "0 objects", "1 object", "2 objects".
std::string NumObjects(int number);

// What the server says it spent: waiting, decoding and computing.
double ServerMs(const v1::Detections& detections);

// What was found as a table for people, with what the server says limited it.
// `round_trip_ms` is the time of the whole call.
std::string Report(const v1::Detections& detections, double round_trip_ms);

}  // namespace fovea::cli
