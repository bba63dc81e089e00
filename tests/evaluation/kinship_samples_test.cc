#include "tests/evaluation/kinship_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/core.hpp>

#include "tests/support/labelled_frame.h"
#include "tests/support/random_scene.h"

namespace fovea::evaluation {
namespace {

std::vector<KinshipSample> SamplesOf(const std::string& kind, bool with_objects) {
  const scenes::LabelledFrame truth =
      scenes::MakeFrame(scenes::RandomScene(kind, 21), scenes::SensorKind::kKinect, 1);
  Scene scene{kind, truth.frame, truth.labels, truth.frame.depth_m == truth.frame.depth_m};
  if (!with_objects) scene.truth.setTo(0);
  return SampleKinship(scene, OptionsOfProfile("default"));
}

TEST(SampleKinship, TellsPartsOfOneObjectFromTwoObjects) {
  const std::vector<KinshipSample> samples = SamplesOf("touching", true);
  const auto num_one = std::count_if(samples.begin(), samples.end(),
                                     [](const auto& sample) { return sample.one_object; });
  EXPECT_GT(num_one, 0);
  EXPECT_LT(num_one, static_cast<std::ptrdiff_t>(samples.size()));
  for (const KinshipSample& sample : samples) {
    EXPECT_GT(sample.weight, 0);
    EXPECT_LE(sample.weight, 1);
  }
}

TEST(SampleKinship, TakesTwoObjectsOnce) {
  const cv::Mat truth =
      scenes::MakeFrame(scenes::RandomScene("touching", 21), scenes::SensorKind::kKinect, 1).labels;
  double num_objects = 0;  // the background is label 0
  cv::minMaxLoc(truth, nullptr, &num_objects);
  const std::vector<KinshipSample> samples = SamplesOf("touching", true);
  const auto num_two = std::count_if(samples.begin(), samples.end(),
                                     [](const auto& sample) { return !sample.one_object; });
  EXPECT_LE(static_cast<double>(num_two), num_objects * (num_objects + 1) / 2);
}

TEST(SampleKinship, TakesAllOfTheBackgroundForOneThingThatMattersLittle) {
  const std::vector<KinshipSample> samples = SamplesOf("touching", false);
  ASSERT_FALSE(samples.empty());
  for (const KinshipSample& sample : samples) {
    EXPECT_TRUE(sample.one_object);
    EXPECT_LT(sample.weight, 0.1);
  }
}

}  // namespace
}  // namespace fovea::evaluation
