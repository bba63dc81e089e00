#include "tests/evaluation/reliability_report.h"

#include <fmt/ostream.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace fovea::evaluation {
namespace {

void PrintTotal(std::ostream& out, const char* title, const Reliability& reliability) {
  fmt::print(out, "  {:28} {:5.1f}% of {} with confidence >= 0.8, calibration error {:.3f}\n",
             title, 100 * reliability.share_of_confident, reliability.confident,
             reliability.calibration_error);
}

}  // namespace

ReliabilityReport ReportReliability(const std::vector<std::vector<Prediction>>& groups) {
  ReliabilityReport report;
  std::vector<Prediction> all;
  for (const std::vector<Prediction>& group : groups) {
    all.insert(all.end(), group.begin(), group.end());
    const Reliability own = MeasureReliability(group);
    report.confident_share_of_groups.emplace_back();
    if (own.confident > 0) report.confident_share_of_groups.back() = own.share_of_confident;
  }
  report.reported = MeasureReliability(all);
  const auto with_predictions =
      std::count_if(groups.begin(), groups.end(), [](const auto& group) { return !group.empty(); });
  if (with_predictions > 1) report.held_out = MeasureReliability(CalibrateHeldOut(groups));
  report.calibration = FitCalibration(std::move(all));
  return report;
}

void PrintReliability(std::ostream& out, const ReliabilityReport& report) {
  fmt::print(out, "\nobjects that are right (box IoU > 0.5) by confidence\n");
  fmt::print(out, "  {:12} {:>6} {:>10} {:>8}\n", "confidence", "count", "mean", "right");
  for (const ReliabilityBin& bin : report.reported.bins) {
    if (bin.count == 0) continue;
    fmt::print(out, "  {:.1f} … {:.1f}    {:6} {:10.3f} {:7.1f}%\n", bin.low, bin.high, bin.count,
               bin.mean_confidence, 100 * bin.share_correct);
  }
  PrintTotal(out, "as reported", report.reported);
  if (report.held_out) {
    PrintTotal(out, "calibrated on other groups", *report.held_out);
  } else {
    fmt::print(out, "  {:28} there are none\n", "calibrated on other groups");
  }
  fmt::print(out, "  {:28}", "as reported, by group");
  for (const std::optional<double>& share : report.confident_share_of_groups) {
    fmt::print(out, " {}", share ? fmt::format("{:.3f}", *share) : "-");
  }
  fmt::print(out, "\n");
}

nlohmann::json ToJson(const Reliability& reliability) {
  nlohmann::json bins = nlohmann::json::array();
  for (const ReliabilityBin& bin : reliability.bins) {
    bins.push_back({{"low", bin.low},
                    {"high", bin.high},
                    {"count", bin.count},
                    {"mean_confidence", bin.mean_confidence},
                    {"share_correct", bin.share_correct}});
  }
  return {{"bins", bins},
          {"calibration_error", reliability.calibration_error},
          {"confident", reliability.confident},
          {"share_of_confident", reliability.share_of_confident}};
}

nlohmann::json ToJson(const ReliabilityReport& report) {
  nlohmann::json shares = nlohmann::json::array();
  for (const std::optional<double>& share : report.confident_share_of_groups) {
    shares.push_back(share ? nlohmann::json(*share) : nlohmann::json());
  }
  nlohmann::json json = {
      {"reported", ToJson(report.reported)},
      {"confident_share_of_groups", shares},
      {"calibration", {{"from", report.calibration.from}, {"share", report.calibration.share}}}};
  if (report.held_out) json["calibrated_on_other_groups"] = ToJson(*report.held_out);
  return json;
}

Series ReliabilityCurve(const std::string& name, const Reliability& reliability) {
  Series series{name, {}, {}};
  for (const ReliabilityBin& bin : reliability.bins) {
    if (bin.count == 0) continue;
    series.x.push_back(bin.mean_confidence);
    series.y.push_back(bin.share_correct);
  }
  return series;
}

Chart ReliabilityChart(const ReliabilityReport& report) {
  Chart chart{.title = "Objects that are right",
              .x_label = "confidence",
              .y_label = "share right",
              .series = {{"ideal", {0, 1}, {0, 1}}, ReliabilityCurve("reported", report.reported)},
              .categories = {}};
  if (report.held_out) chart.series.push_back(ReliabilityCurve("held out", *report.held_out));
  return chart;
}

}  // namespace fovea::evaluation
