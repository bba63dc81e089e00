// Recorded frames with floor, walls and chairs: their objects, and nothing else.
#include <gtest/gtest.h>

#include <map>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/detector.h"
#include "tests/evaluation/dataset.h"
#include "tests/evaluation/scores.h"
#include "tests/support/data_path.h"

namespace fovea::evaluation {
namespace {

constexpr CameraIntrinsics kKinect{525, 525, 319.5, 239.5};

TEST(WholeFrames, OnlyTheObjectsOnTheTableAreReported) {
  const auto data = DataPath("osd_whole");
  if (!data) GTEST_SKIP() << MissingData("osd_whole");
  // Two of the four objects of test42, stacked, are reported as one.
  const std::map<std::string, std::size_t> num_found{
      {"learn6", 2}, {"test42", 3}, {"test50", 7}, {"test64", 15}};
  const std::map<std::string, std::size_t> num_right{
      {"learn6", 2}, {"test42", 3}, {"test50", 7}, {"test64", 14}};
  ASSERT_EQ(SceneNames(*data).size(), num_found.size());
  for (const std::string& name : SceneNames(*data)) {
    const Scene scene = LoadScene(*data, name, LabelEncoding::kMosd, kKinect);
    const Detections found = Detect(scene.frame, OptionsOfProfile("default"));
    EXPECT_EQ(found.objects.size(), num_found.at(name)) << name;
    const ObjectCounts counts = ScoreScene(scene.truth, found.labels, scene.valid).counts;
    EXPECT_EQ(counts.matched_boxes, num_right.at(name)) << name;
  }
}

TEST(WholeFrames, BottlesAndACartonOnAFloor) {
  const auto color = DataPath("floor/floor1_color.png");
  const auto depth = DataPath("floor/floor1_depth.png");
  if (!color || !depth) GTEST_SKIP() << MissingData("floor/floor1");
  RgbdFrame frame;
  cv::cvtColor(cv::imread(color->string()), frame.color_rgb, cv::COLOR_BGR2RGB);
  cv::imread(depth->string(), cv::IMREAD_UNCHANGED).convertTo(frame.depth_m, CV_32F, 0.001);
  frame.intrinsics = kKinect;
  const Detections found = Detect(frame, OptionsOfProfile("default"));
  ASSERT_EQ(found.objects.size(), 3U);  // all whole
  const std::vector<double> heights_m = {0.21, 0.25, 0.23};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(found.objects[i].box.size_m.z(), heights_m[i], 0.02);
    EXPECT_NEAR(*found.objects[i].height_above_support_m, 0, 0.01);
  }
}

}  // namespace
}  // namespace fovea::evaluation
