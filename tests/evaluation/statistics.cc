#include "tests/evaluation/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace fovea::evaluation {

double Quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto below = static_cast<std::size_t>(share * static_cast<double>(values.size()));
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(std::min(below, values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

double Median(std::vector<double> values) { return Quantile(std::move(values), 0.5); }

Spread SpreadOf(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  Spread spread;
  for (const double value : values) spread.mean += value / count;
  if (values.size() < 2) return spread;
  double squares = 0;
  for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
  spread.deviation = std::sqrt(squares / (count - 1));
  return spread;
}

double LineAt(double x, const std::vector<double>& xs, const std::vector<double>& ys) {
  const double mean_x = SpreadOf(xs).mean, mean_y = SpreadOf(ys).mean;
  double products = 0, squares = 0;
  for (std::size_t i = 0; i < xs.size(); ++i) {
    products += (xs[i] - mean_x) * (ys[i] - mean_y);
    squares += (xs[i] - mean_x) * (xs[i] - mean_x);
  }
  return squares > 0 ? mean_y + products / squares * (x - mean_x) : mean_y;
}

}  // namespace fovea::evaluation
