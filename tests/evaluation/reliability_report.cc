#include "tests/evaluation/reliability_report.h"

#include <fmt/ostream.h>
#include <fmt/ranges.h>

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
    report.confident_share_of_groups.push_back(MeasureReliability(group).share_of_confident);
  }
  report.reported = MeasureReliability(all);
  report.held_out = MeasureReliability(CalibrateHeldOut(groups));
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
  PrintTotal(out, "calibrated on other groups", report.held_out);
  fmt::print(out, "  {:28} {:.3f}\n", "as reported, by group",
             fmt::join(report.confident_share_of_groups, " "));
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
  return {
      {"reported", ToJson(report.reported)},
      {"calibrated_on_other_groups", ToJson(report.held_out)},
      {"confident_share_of_groups", report.confident_share_of_groups},
      {"calibration", {{"from", report.calibration.from}, {"share", report.calibration.share}}}};
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
  return {.title = "Objects that are right",
          .x_label = "confidence",
          .y_label = "share right",
          .series = {{"ideal", {0, 1}, {0, 1}},
                     ReliabilityCurve("reported", report.reported),
                     ReliabilityCurve("held out", report.held_out)},
          .categories = {}};
}

}  // namespace fovea::evaluation
