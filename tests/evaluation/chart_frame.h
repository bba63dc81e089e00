// The frame of a chart: where values lie in the picture, and what is written around them.
#pragma once

#include <set>
#include <string>

#include "tests/evaluation/plot.h"

namespace fovea::evaluation {

class ChartFrame {
 public:
  static constexpr int kWidth = 480, kHeight = 340;  // of the whole chart in pixels

  explicit ChartFrame(const Chart& chart);

  double X(double x) const;  // the frame reaches from the least to the largest x of all series
  double Y(double y) const;
  double GroupWidth() const;  // of the bars of a category
  double GroupLeft(std::size_t category) const;

  // Title, border, axes and legend as SVG. `colors[s]` is that of series s.
  std::string Write(const std::vector<std::string>& colors) const;

 private:
  std::string YAxis() const;
  std::string XAxis() const;
  std::string Legend(const std::vector<std::string>& colors) const;

  const Chart& chart_;
  std::set<double> xs_;
};

}  // namespace fovea::evaluation
