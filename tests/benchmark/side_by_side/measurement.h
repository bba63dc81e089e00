// How long methods take on frames, in turn.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tests/benchmark/side_by_side/frame_sets.h"
#include "tests/evaluation/detection_run.h"

namespace fovea::benchmark {

struct Method {
  std::string name;
  evaluation::DetectFunction detect;  // peers have no stages
};

// The profiles, and the peers of tests/evaluation/peers by their names. Throws
// std::invalid_argument for others.
Method MethodOf(const std::string& name);

// Of one method on one set.
struct Measurement {
  // Of each frame the median over the rounds; absent where it refuses the frame.
  std::vector<std::optional<double>> frame_ms;
  std::vector<double> run_ms;                           // of each frame and round
  std::vector<std::string> stages;                      // in the order of the pipeline
  std::map<std::string, std::vector<double>> stage_ms;  // likewise of each frame and round
  double allocations = 0;                               // sum over the frames
  double peak_mb = 0;          // most of the frames, beyond the frame itself
  std::size_t num_failed = 0;  // frames that it refuses
};

// Each frame by each method in turn, over and over: what else the machine does meets all alike. A
// round before those that count warms up.
std::vector<Measurement> Measure(const FrameSet& set, const std::vector<Method>& methods,
                                 int num_rounds, const std::function<void()>& frame_done);

}  // namespace fovea::benchmark
