#include "tests/benchmark/side_by_side/measurement.h"

#include <algorithm>
#include <chrono>

#include "core/types/too_complex.h"
#include "tests/benchmark/side_by_side/allocations.h"
#include "tests/evaluation/peers/peer.h"
#include "tests/evaluation/statistics.h"

namespace fovea::benchmark {
namespace {

using Clock = std::chrono::steady_clock;

struct Run {
  double ms = 0;
  std::vector<StageTime> stages;
  Allocations allocations;
};

Run RunOnce(const Method& method, const evaluation::Scene& scene) {
  Run run;
  const AllocationCounter counter;
  const Clock::time_point start = Clock::now();
  run.stages = method.detect(scene).stage_times;
  run.ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  run.allocations = counter.SoFar();
  return run;
}

// The runs of the next frame; none where it is refused.
void Add(const std::vector<Run>& runs, Measurement& to) {
  if (runs.empty()) {
    to.frame_ms.emplace_back();
    ++to.num_failed;
    return;
  }
  std::vector<double> times;
  for (const Run& run : runs) {
    times.push_back(run.ms);
    to.run_ms.push_back(run.ms);
    for (const StageTime& time : run.stages) {
      if (!to.stage_ms.contains(time.stage)) to.stages.push_back(time.stage);
      to.stage_ms[time.stage].push_back(time.duration_ms);
    }
  }
  to.frame_ms.emplace_back(evaluation::Median(times));
  to.allocations += static_cast<double>(runs.back().allocations.count);
  to.peak_mb = std::max(to.peak_mb, static_cast<double>(runs.back().allocations.peak_bytes) / 1e6);
}

}  // namespace

Method MethodOf(const std::string& name) {
  const std::vector<std::string> peers = evaluation::PeerNames();
  const bool is_peer = std::find(peers.begin(), peers.end(), name) != peers.end();
  return {name, is_peer ? evaluation::DetectWithPeer(name)
                        : evaluation::DetectWith(OptionsOfProfile(name))};
}

std::vector<Measurement> Measure(const FrameSet& set, const std::vector<Method>& methods,
                                 int num_rounds, const std::function<void()>& frame_done) {
  std::vector<Measurement> measurements(methods.size());
  for (const BenchFrame& frame : set.frames) {
    std::vector<std::vector<Run>> runs(methods.size());
    for (int round = 0; round <= num_rounds; ++round) {
      for (std::size_t m = 0; m < methods.size(); ++m) {
        try {
          const Run run = RunOnce(methods[m], frame.scene);
          if (round > 0) runs[m].push_back(run);
        } catch (const TooComplex&) {  // Add counts it
        }
      }
    }
    for (std::size_t m = 0; m < methods.size(); ++m) Add(runs[m], measurements[m]);
    frame_done();
  }
  return measurements;
}

}  // namespace fovea::benchmark
