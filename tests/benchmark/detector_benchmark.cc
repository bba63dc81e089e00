// The whole detector at 640×480 on one thread and with a helper, and where its time goes.
#include <benchmark/benchmark.h>

#include <iterator>
#include <string>

#include "core/detector.h"
#include "core/types/helpers.h"
#include "tests/benchmark/frames.h"

namespace fovea {
namespace {

// Time per frame; one counter a stage, in milliseconds.
void DetectFrame(benchmark::State& state) {
  const std::string profile = ProfileNames()[static_cast<std::size_t>(state.range(0))];
  const std::string& name = FrameNames()[static_cast<std::size_t>(state.range(1))];
  const RgbdFrame frame = ReadFrame(name);
  const DetectorOptions options = OptionsOfProfile(profile);
  Helpers helpers(static_cast<int>(state.range(2)));
  const Helpers::Scope helped(helpers, static_cast<int>(state.range(2)));
  for (auto _ : state) {
    for (const StageTime& time : Detect(frame, options).stage_times) {
      state.counters[time.stage] += time.duration_ms;
    }
  }
  for (auto& [stage, counter] : state.counters) counter.flags = benchmark::Counter::kAvgIterations;
  state.SetLabel(profile + ", " + SourceOf(name));
}

BENCHMARK(DetectFrame)
    ->ArgNames({"profile", "frame", "threads"})
    ->ArgsProduct({benchmark::CreateDenseRange(0, std::ssize(ProfileNames()) - 1, /*step=*/1),
                   benchmark::CreateDenseRange(0, 3, /*step=*/1),
                   {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fovea
