#include "tests/evaluation/plot.h"

#include <fmt/format.h>

#include <array>

#include "tests/evaluation/chart_frame.h"

namespace fovea::evaluation {
namespace {

// Told apart also by people who confuse red and green (Okabe and Ito).
std::vector<std::string> Colors(std::size_t count) {
  constexpr std::array kColors = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};
  std::vector<std::string> colors;
  for (std::size_t i = 0; i < count; ++i) colors.emplace_back(kColors[i % kColors.size()]);
  return colors;
}

std::string Line(const ChartFrame& frame, const Series& series, const std::string& color) {
  std::string points, dots;
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const double x = frame.X(series.x[i]), y = frame.Y(series.y[i]);
    points += fmt::format("{:.1f},{:.1f} ", x, y);
    dots +=
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\" fill=\"{}\"/>\n", x, y, color);
  }
  return fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\"/>\n{}", points, color,
                     dots);
}

// The bars of series `index` in all groups; a fifth of each group stays empty.
std::string Bars(const ChartFrame& frame, const Chart& chart, std::size_t index,
                 const std::string& color) {
  const double width = frame.GroupWidth() * 0.8 / static_cast<double>(chart.series.size());
  const std::vector<double>& values = chart.series[index].y;
  std::string svg;
  for (std::size_t c = 0; c < values.size(); ++c) {
    const double x = frame.GroupLeft(c) + frame.GroupWidth() * 0.1 + width * double(index);
    const double top = frame.Y(values[c]), height = frame.Y(chart.y_min) - top;
    svg += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>\n", x,
        top, width, height, color);
  }
  return svg;
}

std::string Draw(const Chart& chart) {
  const ChartFrame frame(chart);
  const std::vector<std::string> colors = Colors(chart.series.size());
  std::string svg = frame.Write(colors);
  for (std::size_t s = 0; s < chart.series.size(); ++s) {
    svg += chart.categories.empty() ? Line(frame, chart.series[s], colors[s])
                                    : Bars(frame, chart, s, colors[s]);
  }
  return svg;
}

}  // namespace

std::string DrawSvg(const std::vector<Chart>& charts) {
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" font-family=\"sans-serif\" font-size=\"11\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      ChartFrame::kWidth * charts.size(), int{ChartFrame::kHeight});
  for (std::size_t i = 0; i < charts.size(); ++i) {
    svg += fmt::format("<g transform=\"translate({},0)\">\n{}</g>\n", ChartFrame::kWidth * i,
                       Draw(charts[i]));
  }
  return svg + "</svg>";
}

}  // namespace fovea::evaluation
