#include "tests/evaluation/chart_frame.h"

#include <fmt/format.h>

#include <algorithm>

namespace fovea::evaluation {
namespace {

constexpr int kLeft = 60, kTop = 34, kPlotWidth = 290, kPlotHeight = 250;  // of the frame
constexpr int kBelow = kTop + kPlotHeight + 16;
constexpr int kNumTicks = 5;

std::string Escape(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    escaped += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return escaped;
}

std::string Text(double x, double y, const char* anchor, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     Escape(text));
}

// The values themselves where they are few.
std::set<double> XTicks(const std::set<double>& xs) {
  constexpr std::size_t kFew = 9;
  constexpr int kNumSteps = 4;
  if (xs.size() <= kFew) return xs;
  std::set<double> ticks;
  for (int i = 0; i <= kNumSteps; ++i) {
    ticks.insert(*xs.begin() + (*xs.rbegin() - *xs.begin()) * i / kNumSteps);
  }
  return ticks;
}

}  // namespace

ChartFrame::ChartFrame(const Chart& chart) : chart_(chart) {
  for (const Series& series : chart.series) xs_.insert(series.x.begin(), series.x.end());
}

double ChartFrame::X(double x) const {
  const double low = *xs_.begin(), range = std::max(*xs_.rbegin() - low, 1e-9);
  return kLeft + kPlotWidth * (x - low) / range;
}

double ChartFrame::Y(double y) const {
  return kTop + kPlotHeight * (chart_.y_max - y) / (chart_.y_max - chart_.y_min);
}

double ChartFrame::GroupWidth() const {
  return static_cast<double>(kPlotWidth) / static_cast<double>(chart_.categories.size());
}

double ChartFrame::GroupLeft(std::size_t category) const {
  return kLeft + GroupWidth() * static_cast<double>(category);
}

std::string ChartFrame::Write(const std::vector<std::string>& colors) const {
  const std::string border = fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#888\"/>\n", kLeft,
      kTop, kPlotWidth, kPlotHeight);
  return Text(kLeft, kTop - 12, "start", chart_.title) + border + YAxis() + XAxis() +
         Legend(colors);
}

std::string ChartFrame::YAxis() const {
  std::string svg;
  for (int i = 0; i <= kNumTicks; ++i) {
    const double y = chart_.y_min + (chart_.y_max - chart_.y_min) * i / kNumTicks;
    svg += fmt::format("<path d=\"M{} {:.1f}h{}\" stroke=\"#ddd\"/>\n", kLeft, Y(y), kPlotWidth);
    svg += Text(kLeft - 5, Y(y) + 4, "end", fmt::format("{:.4g}", y));
  }
  return svg + fmt::format(
                   "<text transform=\"translate(14,{}) rotate(-90)\" "
                   "text-anchor=\"middle\">{}</text>\n",
                   kTop + kPlotHeight / 2, Escape(chart_.y_label));
}

std::string ChartFrame::XAxis() const {
  std::string svg = Text(kLeft + kPlotWidth / 2.0, kBelow + 20, "middle", chart_.x_label);
  for (std::size_t c = 0; c < chart_.categories.size(); ++c) {
    svg += Text(GroupLeft(c) + GroupWidth() / 2, kBelow, "middle", chart_.categories[c]);
  }
  for (const double x : XTicks(xs_)) {
    svg += Text(X(x), kBelow, "middle", fmt::format("{:.4g}", x));
  }
  return svg;
}

std::string ChartFrame::Legend(const std::vector<std::string>& colors) const {
  std::string svg;
  for (std::size_t s = 0; s < chart_.series.size(); ++s) {
    const int x = kLeft + kPlotWidth + 8, y = kTop + 8 + 18 * static_cast<int>(s);
    svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"10\" height=\"10\" fill=\"{}\"/>\n", x, y,
                       colors[s]);
    svg += Text(x + 14, y + 9, "start", chart_.series[s].name);
  }
  return svg;
}

}  // namespace fovea::evaluation
