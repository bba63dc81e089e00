// Every kind of scene keeps the promises of random_scene.h and placement.h, for several seeds.
#include "tests/support/random_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/core.hpp>

#include "tests/support/labelled_frame.h"
#include "tests/support/placement.h"
#include "tests/support/random_objects.h"
#include "tests/support/render.h"

namespace fovea::scenes {
namespace {

constexpr std::uint64_t kSceneSeeds = 6;

class SceneOfKind : public testing::TestWithParam<std::string> {
 protected:
  // Runs a check for each seed and names the seed in its failures.
  template <typename Check>
  void ForEachSeed(const Check& check) {
    for (std::uint64_t seed = 1; seed <= kSceneSeeds; ++seed) {
      SCOPED_TRACE("kind " + GetParam() + ", seed " + std::to_string(seed));
      check(RandomScene(GetParam(), seed, {320, 240}), seed);
    }
  }
};

TEST_P(SceneOfKind, HasObjectsUnlessEmpty) {
  ForEachSeed([](const Scene& scene, std::uint64_t) {
    EXPECT_EQ(ObjectsOf(scene).empty(), GetParam() == "empty_table");
    EXPECT_FALSE(scene.supports.empty());
  });
}

TEST_P(SceneOfKind, ObjectsShareNoVolumeWithAnything) {
  ForEachSeed([](const Scene& scene, std::uint64_t) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Body &a = scene.bodies[i], &b = scene.bodies[j];
        if (a.is_object || b.is_object) {
          EXPECT_FALSE(Overlap(a, b)) << a.name << " and " << b.name;
        }
      }
    }
  });
}

TEST_P(SceneOfKind, ObjectsRestOnASupportOrOnAnotherObject) {
  ForEachSeed([](const Scene& scene, std::uint64_t) {
    for (const Body* const body : ObjectsOf(scene)) {
      const Body& object = *body;
      const double low = VerticalExtent(object).first;
      const auto at_its_foot = [&](double height) { return std::abs(height - low) < 1e-9; };
      const bool carried =
          std::any_of(scene.supports.begin(), scene.supports.end(),
                      [&](const Support& support) { return at_its_foot(support.height_m); }) ||
          std::any_of(scene.bodies.begin(), scene.bodies.end(), [&](const Body& other) {
            return other.is_object && at_its_foot(VerticalExtent(other).second);
          });
      EXPECT_TRUE(carried) << object.name << " floats at " << low << " m";
    }
  });
}

TEST_P(SceneOfKind, ObjectsAreVisible) {
  ForEachSeed([](const Scene& scene, std::uint64_t) {
    const cv::Mat labels = RenderLabels(scene);
    const std::vector<const Body*> objects = ObjectsOf(scene);
    for (std::size_t k = 1; k <= objects.size(); ++k) {
      EXPECT_GE(cv::countNonZero(labels == static_cast<double>(k)), 60) << objects[k - 1]->name;
    }
  });
}

TEST_P(SceneOfKind, IsTheSameForTheSameSeed) {
  ForEachSeed([](const Scene& scene, std::uint64_t seed) {
    const cv::Mat depth_m = RenderDepth(scene);
    const cv::Mat again_m = RenderDepth(RandomScene(GetParam(), seed, {320, 240}));
    EXPECT_EQ(cv::countNonZero(depth_m == again_m), cv::countNonZero(depth_m == depth_m));
  });
}

// Of one seed only: full frames take their time.
TEST_P(SceneOfKind, FrameHasDepthButForHoles) {
  const LabelledFrame labelled =
      MakeFrame(RandomScene(GetParam(), 1, {320, 240}), SensorKind::kKinect, 1);
  EXPECT_NO_THROW(Validate(labelled.frame));
  const cv::Mat measured = labelled.frame.depth_m == labelled.frame.depth_m;
  EXPECT_GT(cv::countNonZero(measured), 0.6 * measured.total());
  EXPECT_LT(cv::countNonZero(measured), measured.total()) << "a real sensor leaves holes";
}

INSTANTIATE_TEST_SUITE_P(All, SceneOfKind, testing::ValuesIn(SceneKinds()),
                         [](const auto& param_info) { return param_info.param; });

TEST(RandomScene, RejectsAnUnknownKind) {
  EXPECT_THROW(RandomScene("beach", 1), std::invalid_argument);
}

TEST(Placement, BesideTouches) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    Scene scene;
    scene.supports = {{0, {0, 0}, {1, 1}}};
    const Area area = {scene.supports[0], 0.5};
    ASSERT_TRUE(PlaceFreely(scene, RandomObject(random, 1), area, 0.01, random));
    if (!PlaceBeside(scene, RandomObject(random, 1), area, random)) continue;
    EXPECT_FALSE(Overlap(scene.bodies[0], scene.bodies[1])) << "seed " << seed;
    EXPECT_TRUE(Overlap(scene.bodies[0], scene.bodies[1], 2e-4)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace fovea::scenes
