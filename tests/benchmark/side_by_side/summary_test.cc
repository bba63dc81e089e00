#include "tests/benchmark/side_by_side/summary.h"

#include <gtest/gtest.h>

namespace fovea::benchmark {
namespace {

FrameSet ThreeFrames() {
  FrameSet set;
  for (const int width : {100, 200, 1000}) {
    BenchFrame frame;
    frame.scene.frame.depth_m = cv::Mat(10, width, CV_32F);
    frame.num_objects = 2;
    set.frames.push_back(frame);
  }
  return set;
}

TEST(BenchFigures, CompareFramesThatBothMeasured) {
  Measurement own, reference;
  own.frame_ms = {std::nullopt, 6.0, 20.0};  // refuses the first
  own.run_ms = {6, 20};
  own.allocations = 30;
  reference.frame_ms = {1.0, 2.0, std::nullopt};
  const BenchFigures figures = FiguresOf(ThreeFrames(), own, reference);
  EXPECT_EQ(figures.ratio, 3);
  EXPECT_EQ(figures.median_ms, 20);  // the upper of two
  EXPECT_DOUBLE_EQ(*figures.ns_per_pixel, 26e6 / 12000);
  EXPECT_DOUBLE_EQ(*figures.ms_per_object, 26.0 / 4);
  EXPECT_DOUBLE_EQ(*figures.allocations, 15);
}

TEST(BenchFigures, AreNoneWhereEveryFrameIsRefused) {
  Measurement own, reference;
  own.frame_ms = {std::nullopt, std::nullopt, std::nullopt};
  reference.frame_ms = {1.0, 2.0, 3.0};
  const BenchFigures none = FiguresOf(ThreeFrames(), own, reference);
  EXPECT_FALSE(none.ratio || none.median_ms || none.ns_per_pixel || none.allocations);
  reference.run_ms = {1, 2, 3};
  const BenchFigures figures = FiguresOf(ThreeFrames(), reference, own);
  EXPECT_FALSE(figures.ratio);
  EXPECT_EQ(figures.median_ms, 2);
}

}  // namespace
}  // namespace fovea::benchmark
