#include "tests/evaluation/true_seeds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

#include "tests/support/labelled_frame.h"
#include "tests/support/random_scene.h"
#include "tests/support/sensor.h"

namespace fovea::evaluation {
namespace {

using ::testing::ElementsAre;

TEST(TrueSeeds, AreTheMeasuredPixelsNearestToTheCentroids) {
  Scene scene;
  scene.truth = (cv::Mat_<std::uint16_t>(2, 5) << 7, 7, 7, 0, 2,  //
                 0, 0, 0, 0, 3);
  scene.frame.depth_m = cv::Mat(2, 5, CV_32FC1, cv::Scalar(1.0F));
  scene.frame.depth_m.at<float>(1, 4) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(TrueSeeds(scene), ElementsAre(cv::Point(4, 0), cv::Point(1, 0)));
  scene.frame.depth_m.at<float>(0, 1) = 0;
  EXPECT_THAT(TrueSeeds(scene), ElementsAre(cv::Point(4, 0), cv::Point(0, 0)));
}

TEST(DetectFromTrueSeeds, BeginsWithThem) {
  const auto truth = scenes::MakeFrame(scenes::RandomScene("tabletop", 1, {320, 240}),
                                       scenes::SensorKind::kKinect, 1);
  const Scene scene{"scene", truth.frame, truth.labels, {}};
  const Detections found = DetectFromTrueSeeds(OptionsOfProfile("paper"))(scene);
  const Diagnostics& counts = found.diagnostics;
  EXPECT_EQ(counts.num_seeds + counts.seeds_on_support, TrueSeeds(scene).size());
  EXPECT_GT(counts.num_seeds, 0U);
  EXPECT_THROW(DetectFromTrueSeeds(OptionsOfProfile("default")), std::invalid_argument);
}

}  // namespace
}  // namespace fovea::evaluation
