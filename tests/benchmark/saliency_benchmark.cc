// Saliency maps and seeds at 640×480, the former also with a helper, on a recorded frame where
// there is one.
#include <benchmark/benchmark.h>

#include "core/paper/superpixel_contrast.h"
#include "core/saliency/depth_saliency.h"
#include "core/saliency/strength_saliency.h"
#include "core/seeds/morphology.h"
#include "core/types/helpers.h"
#include "tests/benchmark/frames.h"

namespace fovea {
namespace {

void SaliencyOfColor(benchmark::State& state) {
  const std::string& frame = FrameNames()[static_cast<std::size_t>(state.range(0))];
  const cv::Mat rgb = ReadColor(frame);
  const int num_threads = static_cast<int>(state.range(2));
  Helpers helpers(num_threads);
  const Helpers::Scope helped(helpers, num_threads);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        StrengthSaliency(rgb, {.downscale = static_cast<int>(state.range(1))}));
  }
  state.SetLabel(SourceOf(frame));
}
BENCHMARK(SaliencyOfColor)
    ->ArgNames({"frame", "downscale", "threads"})
    ->ArgsProduct({{0, 1, 2, 3}, {1, 2, 4}, {1, 2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void SaliencyOfDepth(benchmark::State& state) {
  const cv::Mat depth = ReadDepth(FrameNames()[1]);
  const Contrast contrast = paper::ContrastOfSuperpixels(static_cast<double>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(DepthSaliency(depth, {}, contrast));
  state.SetLabel(SourceOf(FrameNames()[1]));
}
BENCHMARK(SaliencyOfDepth)->ArgName("superpixels")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

void Erosion(benchmark::State& state) {
  const cv::Mat map = StrengthSaliency(ReadColor(FrameNames()[1]));
  for (auto _ : state) {
    benchmark::DoNotOptimize(ErodeByDisk(map, static_cast<int>(state.range(0))));
  }
  state.SetLabel(SourceOf(FrameNames()[1]));
}
BENCHMARK(Erosion)->ArgName("radius")->Arg(5)->Arg(10)->Arg(20)->Unit(benchmark::kMillisecond);

void Reconstruction(benchmark::State& state) {
  const cv::Mat map = StrengthSaliency(ReadColor(FrameNames()[1]));
  const cv::Mat marker = ErodeByDisk(map, static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(ReconstructByDilation(marker, map));
  state.SetLabel(SourceOf(FrameNames()[1]));
}
BENCHMARK(Reconstruction)->ArgName("radius")->Arg(5)->Arg(20)->Unit(benchmark::kMillisecond);

void RegionalMaxima(benchmark::State& state) {
  const cv::Mat map = StrengthSaliency(ReadColor(FrameNames()[1]));
  const cv::Mat opened =
      ReconstructByDilation(ErodeByDisk(map, static_cast<int>(state.range(0))), map);
  for (auto _ : state) benchmark::DoNotOptimize(LabelRegionalMaxima(opened));
  state.SetLabel(SourceOf(FrameNames()[1]));
}
BENCHMARK(RegionalMaxima)->ArgName("radius")->Arg(5)->Arg(20)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fovea
