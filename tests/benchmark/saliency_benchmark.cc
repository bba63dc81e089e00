// Saliency maps and seeds at 640×480, on a recorded frame where there is one.
#include <benchmark/benchmark.h>

#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "core/saliency/depth_saliency.h"
#include "core/saliency/strength_saliency.h"
#include "core/seeds/morphology.h"
#include "tests/support/data_path.h"

namespace fovea {
namespace {

// Cluttered scenes first to last, from easy to hard for the propagation.
const std::vector<std::string> kFrames{"osd/learn0", "osd/learn40", "osd/test58", "floor/floor1"};

cv::Mat GeneratedColor() {
  cv::Mat rgb(480, 640, CV_8UC3, cv::Scalar(120, 110, 90));
  cv::RNG random(7);
  for (int i = 0; i < 15; ++i) {
    const cv::Point center(random.uniform(80, 560), random.uniform(80, 400));
    cv::circle(rgb, center, random.uniform(10, 60),
               {random.uniform(0., 255.), random.uniform(0., 255.), random.uniform(0., 255.)}, -1);
  }
  cv::Mat noise(rgb.size(), CV_8UC3);
  random.fill(noise, cv::RNG::NORMAL, 8, 3);
  return rgb + noise;
}

cv::Mat ReadColor(const std::string& frame) {
  const auto path = DataPath(frame + "_color.png");
  if (!path) return GeneratedColor();
  cv::Mat rgb;
  cv::cvtColor(cv::imread(path->string()), rgb, cv::COLOR_BGR2RGB);
  return rgb;
}

cv::Mat ReadDepth(const std::string& frame) {
  cv::Mat depth;
  if (const auto path = DataPath(frame + "_depth.png")) {
    cv::imread(path->string(), cv::IMREAD_UNCHANGED).convertTo(depth, CV_32F, 1e-3);
    depth.setTo(std::numeric_limits<float>::quiet_NaN(), depth == 0);
  } else {
    cv::cvtColor(GeneratedColor(), depth, cv::COLOR_RGB2GRAY);
    depth.convertTo(depth, CV_32F, 1 / 100.0, 0.5);
  }
  return depth;
}

void SaliencyOfColor(benchmark::State& state) {
  const std::string& frame = kFrames[static_cast<std::size_t>(state.range(0))];
  const cv::Mat rgb = ReadColor(frame);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        StrengthSaliency(rgb, {.downscale = static_cast<int>(state.range(1))}));
  }
  state.SetLabel(frame);
}
BENCHMARK(SaliencyOfColor)
    ->ArgNames({"frame", "downscale"})
    ->ArgsProduct({{0, 1, 2, 3}, {1, 2, 4}})
    ->Unit(benchmark::kMillisecond);

void SaliencyOfDepth(benchmark::State& state) {
  const cv::Mat depth = ReadDepth(kFrames[1]);
  const DepthSaliencyOptions options{.superpixels_per_diagonal =
                                         static_cast<double>(state.range(0))};
  for (auto _ : state) benchmark::DoNotOptimize(DepthSaliency(depth, options));
}
BENCHMARK(SaliencyOfDepth)->ArgName("superpixels")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

void Erosion(benchmark::State& state) {
  const cv::Mat map = StrengthSaliency(ReadColor(kFrames[1]));
  for (auto _ : state) {
    benchmark::DoNotOptimize(ErodeByDisk(map, static_cast<int>(state.range(0))));
  }
}
BENCHMARK(Erosion)->ArgName("radius")->Arg(5)->Arg(10)->Arg(20)->Unit(benchmark::kMillisecond);

void Reconstruction(benchmark::State& state) {
  const cv::Mat map = StrengthSaliency(ReadColor(kFrames[1]));
  const cv::Mat marker = ErodeByDisk(map, static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(ReconstructByDilation(marker, map));
}
BENCHMARK(Reconstruction)->ArgName("radius")->Arg(5)->Arg(20)->Unit(benchmark::kMillisecond);

void RegionalMaxima(benchmark::State& state) {
  const cv::Mat map = StrengthSaliency(ReadColor(kFrames[1]));
  const cv::Mat opened =
      ReconstructByDilation(ErodeByDisk(map, static_cast<int>(state.range(0))), map);
  for (auto _ : state) benchmark::DoNotOptimize(LabelRegionalMaxima(opened));
}
BENCHMARK(RegionalMaxima)->ArgName("radius")->Arg(5)->Arg(20)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fovea
