#include "server/rpc/frame_room.h"

#include <gtest/gtest.h>

#include <vector>

namespace fovea::testing {
namespace {

using server::FrameRoom;

TEST(FrameRoom, HasRoomForAQuarterOfWhatIsLeft) {
  FrameRoom room(100);
  const auto first = room.Take("a", 20);
  EXPECT_TRUE(first);
  EXPECT_FALSE(room.Take("b", 21)) << "of 80";
  const auto next = room.Take("b", 20);
  EXPECT_TRUE(next);
  EXPECT_TRUE(room.Take("c", 15)) << "of 60, and given back";
  EXPECT_TRUE(room.Take("c", 15));
}

TEST(FrameRoom, HasRoomForWhateverIsAlone) {
  FrameRoom room(100);
  auto all = room.Take("a", 500);
  EXPECT_TRUE(all);
  EXPECT_FALSE(room.Take("a", 1));
  all.reset();
  EXPECT_TRUE(room.Take("a", 90));
}

TEST(FrameRoom, OfOneWithManyFramesLeavesSomeToOthers) {
  constexpr std::size_t kMiB = std::size_t{1} << 20, kFrame = 3 * kMiB / 2;
  FrameRoom room(512 * kMiB);
  std::vector<FrameRoom::Place> many;
  for (std::size_t size = 24 * kMiB; size > kMiB / 2; size /= 2) {
    for (int stream = 0; stream < 32; ++stream) many.push_back(room.Take("a", size));
  }
  EXPECT_FALSE(room.Take("a", kFrame));
  auto place = room.Take("b", 24 * kMiB);
  EXPECT_TRUE(place);
  EXPECT_FALSE(room.Take("b", kFrame)) << "what is kept is for those that have nothing";
  place.reset();
  EXPECT_TRUE(room.Take("b", kFrame));
  many.clear();
  EXPECT_TRUE(room.Take("a", 512 * kMiB)) << "all is given back";
}

}  // namespace
}  // namespace fovea::testing
