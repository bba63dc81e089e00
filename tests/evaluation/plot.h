// Plots as SVG, for reports: line and bar charts.
#pragma once

#include <string>
#include <vector>

namespace fovea::evaluation {

struct Series {
  std::string name;
  std::vector<double> x;  // of a bar chart: empty
  std::vector<double> y;
};

struct Chart {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<Series> series;           // at least one point in all
  std::vector<std::string> categories;  // a group of bars for each; none: a line for each series
  double y_min = 0;
  double y_max = 1;
};

// Draws the charts side by side. Points outside the range of y leave the frame; text is escaped.
std::string DrawSvg(const std::vector<Chart>& charts);

}  // namespace fovea::evaluation
