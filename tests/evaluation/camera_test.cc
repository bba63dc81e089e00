// Objects are found whatever the camera's resolution, however it is turned about its optical axis
// and however little light there is: bounds on box precision and recall over several scenes, with a
// margin from what was measured.
#include <gtest/gtest.h>

#include <cstdlib>
#include <numbers>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "core/detector.h"
#include "tests/evaluation/scores.h"
#include "tests/support/labelled_frame.h"
#include "tests/support/random_scene.h"

namespace fovea::evaluation {
namespace {

using scenes::SensorKind;

struct Camera {
  cv::Size size_px{320, 240};
  double roll_deg = 0;
  double brightness = 1;
};

ObjectCounts CountFound(const scenes::Scene& scene, double brightness) {
  scenes::LabelledFrame truth = scenes::MakeFrame(scene, SensorKind::kKinect, 1);
  truth.frame.color_rgb *= brightness;
  const Detections found = Detect(truth.frame, OptionsOfProfile("default"));
  const cv::Mat measured = truth.frame.depth_m == truth.frame.depth_m;
  return ScoreScene(truth.labels, found.labels, measured).counts;
}

// Over scenes of these kinds, seeds 21, 22, …
Score BoxesFound(const std::vector<std::string>& kinds, int count, const Camera& camera) {
  ObjectCounts sum;
  for (const std::string& kind : kinds) {
    for (int seed = 21; seed < 21 + count; ++seed) {
      const scenes::Scene scene = scenes::RandomScene(kind, seed, camera.size_px);
      const ObjectCounts counts = CountFound(
          scenes::Rolled(scene, camera.roll_deg * std::numbers::pi / 180), camera.brightness);
      sum.truth += counts.truth;
      sum.predicted += counts.predicted;
      sum.matched_boxes += counts.matched_boxes;
    }
  }
  return MakeScore(sum.matched_boxes, sum.predicted, sum.matched_boxes, sum.truth);
}

class RolledCamera : public testing::TestWithParam<int> {};

TEST_P(RolledCamera, FindsTheObjects) {
  const Score boxes = BoxesFound({"tabletop", "cluttered"}, 3, {.roll_deg = double(GetParam())});
  EXPECT_GT(boxes.precision, 0.87);  // measured: 0.95 to 1; without roll 1
  EXPECT_GT(boxes.recall, 0.75);     // measured: 0.86 to 0.88; without roll 0.88
}

INSTANTIATE_TEST_SUITE_P(Degrees, RolledCamera, testing::Values(-30, -15, 15, 30),
                         [](const auto& test) {
                           return (test.param < 0 ? "Minus" : "Plus") +
                                  std::to_string(std::abs(test.param));
                         });

class CameraOfSize : public testing::TestWithParam<cv::Size> {};

TEST_P(CameraOfSize, FindsTheObjects) {
  const Score boxes = BoxesFound({"tabletop", "cluttered"}, 1, {.size_px = GetParam()});
  EXPECT_GT(boxes.precision, 0.8);  // measured: 0.93 or more
  EXPECT_GT(boxes.recall, 0.8);     // measured: 0.93 or more
}

INSTANTIATE_TEST_SUITE_P(Pixels, CameraOfSize,
                         testing::Values(cv::Size(320, 240), cv::Size(640, 480),
                                         cv::Size(1280, 720), cv::Size(1920, 1080)),
                         [](const auto& test) {
                           return std::to_string(test.param.width) + "x" +
                                  std::to_string(test.param.height);
                         });

class RoomWithLight : public testing::TestWithParam<double> {};

TEST_P(RoomWithLight, FindsTheObjects) {
  const Score boxes = BoxesFound({"tabletop", "cluttered"}, 3, {.brightness = GetParam()});
  EXPECT_GT(boxes.precision, 0.9);  // measured: 1
  EXPECT_GT(boxes.recall, 0.75);    // measured: 0.93, without any 0.81
}

INSTANTIATE_TEST_SUITE_P(Percent, RoomWithLight, testing::Values(1, 0.2, 0.05, 0),
                         [](const auto& test) {
                           return std::to_string(static_cast<int>(100 * test.param));
                         });

}  // namespace
}  // namespace fovea::evaluation
