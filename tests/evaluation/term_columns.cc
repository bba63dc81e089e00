#include "tests/evaluation/term_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace fovea::evaluation {

TermFunction WithKnotsAt(std::vector<double> values) {
  constexpr std::array<double, TermFunction::kNumKnots> kQuantiles = {0.2, 0.4, 0.6, 0.8, 0.93};
  TermFunction function;
  std::sort(values.begin(), values.end());
  if (std::set<double>(values.begin(), values.end()).size() <= 2) return function;
  std::size_t k = 0;
  for (const double quantile : kQuantiles) {
    const double place = quantile * static_cast<double>(values.size() - 1);
    const double value = values[static_cast<std::size_t>(place)];
    const double last = k == 0 ? values.front() : function.knots[k - 1];
    if (value > last) function.knots[k++] = value;
  }
  return function;
}

Eigen::Matrix<double, 1, kColumnsOfTerm> ColumnsOf(const TermFunction& knots, double term) {
  Eigen::Matrix<double, 1, kColumnsOfTerm> columns;
  columns[0] = term;
  for (int k = 0; k + 1 < kColumnsOfTerm; ++k) {
    columns[k + 1] = std::max(0.0, term - knots.knots[static_cast<std::size_t>(k)]);
  }
  return columns;
}

std::string SourceOf(const TermFunction& function) {
  std::vector<std::string> knots;
  for (const double knot : function.knots) {
    knots.push_back(knot < TermFunction::kNoKnot ? fmt::format("{:.5g}", knot) : "kNone");
  }
  return fmt::format("{{{{{}}}, {{{:.5g}}}}}", fmt::join(knots, ", "),
                     fmt::join(function.slopes, ", "));
}

}  // namespace fovea::evaluation
