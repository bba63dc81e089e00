// What the measurements of a method on a set come to.
#pragma once

#include <optional>

#include "tests/benchmark/side_by_side/frame_sets.h"
#include "tests/benchmark/side_by_side/measurement.h"

namespace fovea::benchmark {

// Of the frames that the method measured; absent where there are none.
struct BenchFigures {
  std::optional<double> ratio;  // to the reference, of the frames that both measured
  std::optional<double> median_ms, p95_ms, p99_ms, most_ms;
  std::optional<double> ns_per_pixel;
  std::optional<double> ms_per_object;  // where it is known how many there are
  std::optional<double> allocations, peak_mb;
};

BenchFigures FiguresOf(const FrameSet& set, const Measurement& own, const Measurement& reference);

}  // namespace fovea::benchmark
