#include "tests/benchmark/side_by_side/summary.h"

#include <algorithm>

#include "tests/evaluation/statistics.h"

namespace fovea::benchmark {
namespace {

std::optional<double> MedianRatio(const Measurement& own, const Measurement& reference) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(own.frame_ms.size(), reference.frame_ms.size()); ++i) {
    const std::optional<double>&a = own.frame_ms[i], &b = reference.frame_ms[i];
    if (a && b) ratios.push_back(*a / *b);
  }
  if (ratios.empty()) return std::nullopt;
  return evaluation::Median(ratios);
}

}  // namespace

BenchFigures FiguresOf(const FrameSet& set, const Measurement& own, const Measurement& reference) {
  std::vector<double> times_ms;
  double total_ms = 0, pixels = 0, objects = 0;
  for (std::size_t i = 0; i < own.frame_ms.size(); ++i) {
    if (!own.frame_ms[i]) continue;
    times_ms.push_back(*own.frame_ms[i]);
    total_ms += times_ms.back();
    pixels += static_cast<double>(set.frames[i].scene.frame.depth_m.total());
    objects += static_cast<double>(set.frames[i].num_objects);
  }
  BenchFigures figures;
  if (times_ms.empty()) return figures;
  const auto at = [&](double share) { return evaluation::Quantile(own.run_ms, share); };
  figures.ratio = MedianRatio(own, reference);
  figures.median_ms = evaluation::Median(times_ms);
  figures.p95_ms = at(0.95);
  figures.p99_ms = at(0.99);
  figures.most_ms = at(1);
  figures.ns_per_pixel = 1e6 * total_ms / pixels;
  if (objects > 0) figures.ms_per_object = total_ms / objects;
  figures.allocations = own.allocations / static_cast<double>(times_ms.size());
  figures.peak_mb = own.peak_mb;
  return figures;
}

}  // namespace fovea::benchmark
