// Figures of tracked streams, as text and JSON.
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "tests/evaluation/tracking/stream_run.h"

namespace fovea::evaluation {

// The names of the columns that ReportTracking prints.
void PrintTrackingHeader();

// Prints a row for all streams of one motion, and where `list_switches` a line per switch; returns
// the same figures.
nlohmann::json ReportTracking(const std::vector<StreamSpec>& specs,
                              const std::vector<std::array<TrackedStream, 2>>& streams, Poses poses,
                              bool list_switches);

}  // namespace fovea::evaluation
