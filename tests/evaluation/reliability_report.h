// How far confidence can be trusted, as text, JSON and a plot.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "tests/evaluation/plot.h"
#include "tests/evaluation/reliability.h"

namespace fovea::evaluation {

struct ReliabilityReport {
  Reliability reported;  // confidences as the detector gives them
  // Calibrated on the other groups; absent where fewer than two have predictions.
  std::optional<Reliability> held_out;
  Calibration calibration;  // on all groups: for use, not for judging
  // Share right among those with confidence ≥ 0.8 in each group; absent in a group without any.
  std::vector<std::optional<double>> confident_share_of_groups;
};

ReliabilityReport ReportReliability(const std::vector<std::vector<Prediction>>& groups);

void PrintReliability(std::ostream& out, const ReliabilityReport& report);
nlohmann::json ToJson(const Reliability& reliability);
nlohmann::json ToJson(const ReliabilityReport& report);

// The share correct over the mean confidence of the bins that have any.
Series ReliabilityCurve(const std::string& name, const Reliability& reliability);
Chart ReliabilityChart(const ReliabilityReport& report);

}  // namespace fovea::evaluation
