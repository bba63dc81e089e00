#include "tests/benchmark/side_by_side/frame_sets.h"

#include <gmock/gmock.h>

namespace fovea::benchmark {
namespace {

TEST(FrameSets, AreThoseWhoseNamesBeginSo) {
  const std::vector<FrameSet> sets = FrameSets(std::nullopt, "checker", 1);
  ASSERT_EQ(sets.size(), 1U);
  EXPECT_EQ(sets[0].name, "checkerboard");
}

TEST(FrameSets, SayThatThereIsNone) {
  EXPECT_THAT(
      [] { FrameSets(std::nullopt, "mosd", 1); },
      testing::ThrowsMessage<std::invalid_argument>("--only mosd: no set of frames begins so"));
}

}  // namespace
}  // namespace fovea::benchmark
