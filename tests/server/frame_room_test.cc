#include "server/rpc/frame_room.h"

#include <gtest/gtest.h>

namespace fovea::testing {
namespace {

using server::FrameRoom;

TEST(FrameRoom, HasRoomForAQuarterOfWhatIsLeft) {
  FrameRoom room(100);
  const auto first = room.Take(20);
  EXPECT_TRUE(first);
  EXPECT_FALSE(room.Take(21)) << "of 80";
  const auto next = room.Take(20);
  EXPECT_TRUE(next);
  EXPECT_TRUE(room.Take(15)) << "of 60, and given back";
  EXPECT_TRUE(room.Take(15));
}

TEST(FrameRoom, HasRoomForWhateverIsAlone) {
  FrameRoom room(100);
  auto all = room.Take(500);
  EXPECT_TRUE(all);
  EXPECT_FALSE(room.Take(1));
  all.reset();
  EXPECT_TRUE(room.Take(90));
}

}  // namespace
}  // namespace fovea::testing
