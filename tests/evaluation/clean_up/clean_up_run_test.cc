#include "tests/evaluation/clean_up/clean_up_run.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace fovea::evaluation {
namespace {

constexpr std::uint64_t kSeed = 3;  // of a floor with a slab

// Such a floor, and the lines that the program says one after the other.
CleanedScene CleanUpWith(const std::vector<std::string>& lines) {
  CleanUpFlags flags;
  flags.num_things = 1;
  flags.first_seed = kSeed;
  flags.program = {"/bin/sh", "-c", R"(for line; do read -r seen; echo "$line"; done)", "program"};
  flags.program.insert(flags.program.end(), lines.begin(), lines.end());
  return CleanUp(flags, [](const CleanedScene&) {}).front();
}

std::string LineOf(const Eigen::Vector3f& point, const Eigen::Vector3f& approach) {
  return fmt::format(R"({{"grasp": {{"gripper_index": 1, "tool_center_point": [{}, {}, {}], )"
                     R"("approach": [{}, {}, {}], "closing": [1, 0, 0]}}}})",
                     point.x(), point.y(), point.z(), approach.x(), approach.y(), approach.z());
}

// The cup in the air.
const std::string kNothing = LineOf({0, 0, 0.2F}, {0, 0, 1});

// The cup from above on the middle of the only thing.
std::string TakeIt() {
  const scenes::Scene scene = ClutteredFloor(kSeed, 1);
  const scenes::Body& thing = *ObjectsOf(scene).front();
  Eigen::Vector3d top = thing.world_from_body.translation();
  top.z() = VerticalExtent(thing).second;
  const Eigen::Isometry3f camera_from_world =
      scene.camera.world_from_camera.inverse().cast<float>();
  return LineOf(camera_from_world * top.cast<float>(),
                camera_from_world.linear() * -Eigen::Vector3f::UnitZ());
}

TEST(CleanUp, GivesUpAfterFourAttemptsForEachThing) {
  const CleanedScene scene = CleanUpWith({kNothing, kNothing, kNothing, kNothing});
  EXPECT_EQ(scene.error, "");
  EXPECT_EQ(scene.attempts.size(), 4U);
  EXPECT_TRUE(scene.gave_up);
  EXPECT_EQ(scene.left.size(), 1U);
}

TEST(CleanUp, IsDoneIfTheLastAttemptTakesTheLastThing) {
  const CleanedScene scene = CleanUpWith({kNothing, kNothing, kNothing, TakeIt()});
  EXPECT_EQ(scene.error, "");
  ASSERT_EQ(scene.attempts.size(), 4U);
  EXPECT_TRUE(scene.attempts.back().TookIt()) << scene.attempts.back().name;
  EXPECT_FALSE(scene.gave_up);
  EXPECT_TRUE(scene.left.empty());
}

}  // namespace
}  // namespace fovea::evaluation
