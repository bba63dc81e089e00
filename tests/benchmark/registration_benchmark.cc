// Depth of 640×480 registered to a colour camera 25 mm beside it, on a recorded frame where there
// is one.
#include <benchmark/benchmark.h>

#include "core/depth/registration.h"
#include "tests/benchmark/frames.h"

namespace fovea {
namespace {

void Registration(benchmark::State& state) {
  const std::string& frame = FrameNames()[static_cast<std::size_t>(state.range(0))];
  const cv::Size size(static_cast<int>(state.range(1)), static_cast<int>(state.range(2)));
  const cv::Mat depth = ReadDepth(frame);
  const CameraIntrinsics depth_camera{525, 525, 319.5, 239.5};
  const double focal_px = 525.0 * size.width / 640;
  const CameraIntrinsics color_camera{focal_px, focal_px, (size.width - 1) / 2.0,
                                      (size.height - 1) / 2.0};
  const Eigen::Isometry3d beside(Eigen::Translation3d(0.025, 0, 0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(RegisterDepth(depth, depth_camera, beside, color_camera, size));
  }
  state.SetLabel(SourceOf(frame));
}
BENCHMARK(Registration)
    ->ArgNames({"frame", "width", "height"})
    ->ArgsProduct({{1, 3}, {320}, {240}})
    ->ArgsProduct({{1, 3}, {640}, {480}})
    ->ArgsProduct({{1, 3}, {1920}, {1080}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fovea
