#include "tests/evaluation/score_charts.h"

namespace fovea::evaluation {
namespace {

template <typename Value>
std::vector<double> Percent(const std::vector<Summary>& summaries, const Value& value) {
  std::vector<double> values;
  values.reserve(summaries.size());
  for (const Summary& summary : summaries) values.push_back(100 * value(summary));
  return values;
}

}  // namespace

Chart SweepChart(const std::string& option, const std::vector<double>& values,
                 const std::vector<Summary>& summaries) {
  const auto series = [&](const char* name, double Score::*score) {
    const auto value = [score](const Summary& s) { return s.boxes.*score; };
    return Series{name, values, Percent(summaries, value)};
  };
  return {.title = "Boxes",
          .x_label = option,
          .y_label = "%",
          .series = {series("precision", &Score::precision), series("recall", &Score::recall),
                     series("F1", &Score::f)},
          .categories = {},
          .y_max = 100};
}

Chart MethodsChart(const std::vector<std::string>& methods, const std::vector<Summary>& summaries) {
  const auto percent = [&](const auto& value) { return Percent(summaries, value); };
  return {.title = "Methods",
          .x_label = "",
          .y_label = "%",
          .series = {{"box F1", {}, percent([](const Summary& s) { return s.boxes.f; })},
                     {"overlap F", {}, percent([](const Summary& s) { return s.overlap.f; })},
                     {"obj75", {}, percent([](const Summary& s) { return s.share_75; })},
                     {"boundary F", {}, percent([](const Summary& s) { return s.boundary.f; })}},
          .categories = methods,
          .y_max = 100};
}

}  // namespace fovea::evaluation
