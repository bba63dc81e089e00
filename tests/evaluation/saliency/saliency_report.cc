#include "tests/evaluation/saliency/saliency_report.h"

#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/evaluation/statistics.h"

namespace fovea::evaluation {
namespace {

struct ScoreKind {
  const char* name;
  double SaliencyScores::*value;
};

constexpr ScoreKind kScores[] = {{"AUC-Borji", &SaliencyScores::auc},
                                 {"NSS", &SaliencyScores::nss},
                                 {"CC", &SaliencyScores::cc}};

// The spread of one score over the images for each sigma.
std::vector<Spread> SpreadsOverImages(const SaliencyResult& result, const ScoreKind& kind) {
  std::vector<Spread> spreads;
  for (const std::vector<SaliencyScores>& images : result.scores) {
    std::vector<double> values;
    for (const SaliencyScores& scores : images) values.push_back(scores.*kind.value);
    spreads.push_back(SpreadOf(values));
  }
  return spreads;
}

std::size_t IndexOfBest(const std::vector<Spread>& spreads) {
  std::size_t best = 0;
  for (std::size_t s = 1; s < spreads.size(); ++s) {
    if (spreads[s].mean > spreads[best].mean) best = s;
  }
  return best;
}

double StandardError(const Spread& spread, std::size_t count) {
  return spread.deviation / std::sqrt(static_cast<double>(count));
}

}  // namespace

void PrintSaliency(std::ostream& out, const std::vector<SaliencyResult>& results,
                   const std::vector<double>& sigmas) {
  fmt::print(out, "{:20}", "");
  for (const ScoreKind& kind : kScores) {
    fmt::print(out, "  {:>9} {:>7}  {:6} {:>5}", kind.name, "best", "", "sigma");
  }
  fmt::print(out, "  {:>7}\n", "ms");
  for (const SaliencyResult& result : results) {
    fmt::print(out, "{:20}", result.method);
    for (const ScoreKind& kind : kScores) {
      const std::vector<Spread> spreads = SpreadsOverImages(result, kind);
      const std::size_t best = IndexOfBest(spreads);
      fmt::print(out, "  {:9.4f} {:7.4f} ±{:.4f} {:5.2f}", spreads[0].mean, spreads[best].mean,
                 StandardError(spreads[best], result.scores[best].size()), sigmas[best]);
    }
    fmt::print(out, "  {:7.1f}\n", result.median_ms);
  }
}

std::vector<Chart> SaliencyCharts(const std::vector<SaliencyResult>& results,
                                  const std::vector<double>& sigmas) {
  std::vector<Chart> charts;
  for (const ScoreKind& kind : kScores) {
    Chart chart{.title = kind.name,
                .x_label = "blur in image widths",
                .y_label = kind.name,
                .series = {},
                .categories = {},
                .y_max = 0};
    for (const SaliencyResult& result : results) {
      const std::vector<Spread> spreads = SpreadsOverImages(result, kind);
      Series series{result.method, sigmas, {}};
      for (const Spread& spread : spreads) series.y.push_back(spread.mean);
      chart.y_max = std::max(chart.y_max, 1.1 * spreads[IndexOfBest(spreads)].mean);
      chart.series.push_back(std::move(series));
    }
    if (chart.y_max == 0) chart.y_max = 1;  // of maps that say nothing
    charts.push_back(std::move(chart));
  }
  return charts;
}

nlohmann::json ToJson(const std::vector<SaliencyResult>& results,
                      const SaliencyRunOptions& options) {
  nlohmann::json methods = nlohmann::json::object();
  for (const SaliencyResult& result : results) {
    nlohmann::json& method = methods[result.method];
    method["median_ms"] = result.median_ms;
    for (const ScoreKind& kind : kScores) {
      const std::vector<Spread> spreads = SpreadsOverImages(result, kind);
      const std::size_t best = IndexOfBest(spreads);
      nlohmann::json means = nlohmann::json::array();
      for (const Spread& spread : spreads) means.push_back(spread.mean);
      method[kind.name] = {
          {"best", spreads[best].mean},
          {"standard_error", StandardError(spreads[best], result.scores[best].size())},
          {"best_sigma", options.sigmas[best]},
          {"means", means}};
    }
  }
  return {{"sigmas", options.sigmas},
          {"blur_border", options.border == cv::BORDER_CONSTANT ? "zero" : "reflect"},
          {"center_prior", options.center_prior},
          {"fixation_sigma", options.fixation_sigma},
          {"seed", options.seed},
          {"methods", methods}};
}

}  // namespace fovea::evaluation
