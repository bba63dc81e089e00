// The whole detector at 640×480 on one thread, and where its time goes.
#include <benchmark/benchmark.h>

#include <opencv2/core/utility.hpp>

#include "core/detector.h"
#include "tests/benchmark/frames.h"

namespace fovea {
namespace {

// Time per frame; one counter a stage, in milliseconds.
void DetectFrame(benchmark::State& state, const std::string& profile) {
  cv::setNumThreads(1);
  const std::string& name = FrameNames()[static_cast<std::size_t>(state.range(0))];
  const RgbdFrame frame = ReadFrame(name);
  const DetectorOptions options = OptionsOfProfile(profile);
  for (auto _ : state) {
    for (const StageTime& time : Detect(frame, options).stage_times) {
      state.counters[time.stage] += time.duration_ms;
    }
  }
  for (auto& [stage, counter] : state.counters) counter.flags = benchmark::Counter::kAvgIterations;
  state.SetLabel(name);
}

void RegisterProfile(const std::string& profile) {
  benchmark::RegisterBenchmark(("Detect/" + profile).c_str(), DetectFrame, profile)
      ->ArgName("frame")
      ->DenseRange(0, 3)
      ->Unit(benchmark::kMillisecond);
}

[[maybe_unused]] const bool kRegistered = [] {
  for (const std::string& profile : ProfileNames()) RegisterProfile(profile);
  return true;
}();

}  // namespace
}  // namespace fovea
