#include "tests/evaluation/real_frames/box_report.h"

#include <fmt/ostream.h>

#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/evaluation/regions.h"
#include "tests/evaluation/statistics.h"
#include "tests/support/label_colors.h"

namespace fovea::evaluation {
namespace {

bool IsOfClearGlass(const std::string& source) { return source.ends_with("_transparent"); }

void PrintRow(std::ostream& out, const std::string& title, const BoxScores& scores) {
  const Score boxes = scores.Boxes();
  fmt::print(out, "{:<28} {:>8} {:>6} {:>6}  {:>6.1f} {:>6.1f} {:>6.1f}\n", title, scores.required,
             scores.found, scores.wrong, 100 * boxes.precision, 100 * boxes.recall, 100 * boxes.f);
}

std::string Counts(const std::map<Failure, int>& counts) {
  std::string text;
  for (const auto& [failure, count] : counts) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, NameOf(failure));
  }
  return text.empty() ? "none" : text;
}

nlohmann::json ToJson(const std::map<Failure, int>& counts) {
  nlohmann::json json = nlohmann::json::object();
  for (const auto& [failure, count] : counts) json[NameOf(failure)] = count;
  return json;
}

nlohmann::json ToJson(const BoxScores& scores) {
  const Score boxes = scores.Boxes();
  return {{"required", scores.required},
          {"found", scores.found},
          {"wrong", scores.wrong},
          {"precision", boxes.precision},
          {"recall", boxes.recall},
          {"f", boxes.f},
          {"missed_by", ToJson(scores.missed)},
          {"wrong_by", ToJson(scores.wrong_by)}};
}

}  // namespace

BoxSummary Summarize(const std::vector<BoxedFrameResult>& results) {
  BoxSummary summary;
  std::vector<double> times;
  for (const BoxedFrameResult& result : results) {
    summary.sources[result.source].Add(result.scores);
    const bool is_clear = IsOfClearGlass(result.source);
    (is_clear ? summary.has_clear : summary.has_all) = true;
    (is_clear ? summary.clear : summary.all).Add(result.scores);
    times.push_back(result.total_ms);
  }
  std::vector<double> f1;
  for (const auto& [source, scores] : summary.sources) {
    if (!IsOfClearGlass(source)) f1.push_back(scores.Boxes().f);
  }
  summary.mean_f1 = SpreadOf(f1).mean;
  summary.median_ms = Median(times);
  return summary;
}

void PrintBoxSummary(std::ostream& out, const std::string& title, const BoxSummary& summary) {
  fmt::print(out, "{:<28} {:>8} {:>6} {:>6}  {:>6} {:>6} {:>6}\n", title, "required", "found",
             "wrong", "P", "R", "F1");
  for (const auto& [source, scores] : summary.sources) PrintRow(out, "  " + source, scores);
  if (summary.has_all) {
    PrintRow(out, "all but clear glass", summary.all);
    fmt::print(out, "{:<28} {:>45.1f}\n", "mean of its sources", 100 * summary.mean_f1);
  }
  if (summary.has_clear) PrintRow(out, "clear glass", summary.clear);
  if (summary.has_all) {
    fmt::print(out, "missed: {}\nwrong:  {}\n", Counts(summary.all.missed),
               Counts(summary.all.wrong_by));
  }
  fmt::print(out, "median {:.0f} ms\n\n", summary.median_ms);
}

void PrintSideBySide(std::ostream& out, const std::vector<std::string>& methods,
                     const std::vector<BoxSummary>& summaries) {
  const auto row = [&](const std::string& title, const auto& value_of) {
    fmt::print(out, "{:<28}", title);
    for (const BoxSummary& summary : summaries) {
      fmt::print(out, " {:>14.1f}", 100 * value_of(summary));
    }
    out << '\n';
  };
  fmt::print(out, "{:<28}", "F1");
  for (const std::string& method : methods) fmt::print(out, " {:>14}", method);
  out << '\n';
  for (const auto& [source, scores] : summaries.front().sources) {
    row("  " + source,
        [&name = source](const BoxSummary& summary) { return summary.sources.at(name).Boxes().f; });
  }
  if (summaries.front().has_all) {
    row("all but clear glass", [](const BoxSummary& summary) { return summary.all.Boxes().f; });
    row("mean of its sources", [](const BoxSummary& summary) { return summary.mean_f1; });
  }
  if (summaries.front().has_clear) {
    row("clear glass", [](const BoxSummary& summary) { return summary.clear.Boxes().f; });
  }
}

nlohmann::json ToJson(const BoxSummary& summary) {
  nlohmann::json json = {{"median_ms", summary.median_ms}};
  if (summary.has_all) {
    json["all"] = ToJson(summary.all);
    json["mean_f1_of_sources"] = summary.mean_f1;
  }
  if (summary.has_clear) json["clear_glass"] = ToJson(summary.clear);
  for (const auto& [source, scores] : summary.sources) json["sources"][source] = ToJson(scores);
  return json;
}

nlohmann::json ToJson(const std::vector<BoxedFrameResult>& results) {
  nlohmann::json frames = nlohmann::json::array();
  for (const BoxedFrameResult& result : results) {
    nlohmann::json frame = ToJson(result.scores);
    frame["source"] = result.source;
    frame["name"] = result.name;
    frame["total_ms"] = result.total_ms;
    frames.push_back(std::move(frame));
  }
  return frames;
}

cv::Mat DrawBoxes(const BoxedFrame& frame, const cv::Mat& labels) {
  const cv::Mat tint = scenes::ColorLabels(labels);
  cv::Mat picture, blended;
  cv::cvtColor(frame.frame.color_rgb, picture, cv::COLOR_RGB2BGR);
  cv::addWeighted(picture, 0.55, tint, 0.45, 0, blended);
  blended.copyTo(picture, labels > 0);
  for (const BoxedObject& object : frame.objects) {
    cv::rectangle(picture, object.box, cv::Scalar::all(object.optional ? 128 : 255), 2);
  }
  for (const Region& region : Regions(labels)) {
    const cv::Mat is_it = labels == region.label;
    cv::rectangle(picture, region.bounds, cv::mean(tint, is_it), 1);
  }
  return picture;
}

}  // namespace fovea::evaluation
