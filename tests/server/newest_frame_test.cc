#include "server/rpc/newest_frame.h"

#include <gtest/gtest.h>

#include <string>

#include "fovea/v1/detection_service.pb.h"

namespace fovea::testing {
namespace {

using server::FrameRoom;
using server::NewestFrame;
using server::ReceivedFrame;

grpc::ByteBuffer FrameBytes(const std::string& profile = {}) {
  v1::DetectStreamRequest request;
  request.mutable_frame()->set_id(std::string(100, 'f'));
  if (!profile.empty()) request.mutable_options()->set_profile(profile);
  const grpc::Slice slice(request.SerializeAsString());
  return {&slice, 1};
}

bool Put(grpc::ByteBuffer bytes, NewestFrame* newest) { return newest->Put("kitchen", &bytes); }

std::string ProfileOf(const std::optional<std::string>& options) {
  v1::DetectOptions parsed;
  if (options) parsed.ParseFromString(*options);
  return parsed.profile();
}

TEST(NewestFrame, DropsWhatWaitedBefore) {
  FrameRoom room(1000);
  NewestFrame newest(room);
  EXPECT_FALSE(newest.waits());
  EXPECT_FALSE(Put(FrameBytes(), &newest));
  EXPECT_TRUE(Put(FrameBytes("paper"), &newest));
  EXPECT_TRUE(Put(FrameBytes(), &newest));
  const ReceivedFrame received = newest.Take();
  EXPECT_FALSE(newest.waits());
  EXPECT_EQ(received.sequence, 2U);
  EXPECT_EQ(newest.num_received(), 3U);
  EXPECT_EQ(received.num_dropped, 2U);
  EXPECT_EQ(ProfileOf(received.options), "paper");
  EXPECT_FALSE(Put(FrameBytes(), &newest));
  const ReceivedFrame next = newest.Take();
  EXPECT_EQ(next.num_dropped, 0U);
  EXPECT_FALSE(next.options);
}

TEST(NewestFrame, KeepsOptionsAloneWhereThereIsNoRoom) {
  FrameRoom room(1000);
  const FrameRoom::Place others = room.Take("hall", 800);
  NewestFrame newest(room);
  EXPECT_FALSE(Put(FrameBytes("paper"), &newest));
  const ReceivedFrame received = newest.Take();
  EXPECT_FALSE(received.room);
  EXPECT_EQ(received.bytes.Length(), 0U);
  EXPECT_EQ(ProfileOf(received.options), "paper");
}

TEST(NewestFrame, GivesBackTheRoomOfWhatItDrops) {
  FrameRoom room(300);
  NewestFrame newest(room);
  for (int i = 0; i < 5; ++i) Put(FrameBytes(), &newest);
  EXPECT_TRUE(newest.Take().room) << "the only one that waits";
  EXPECT_TRUE(room.Take("hall", 300));
}

}  // namespace
}  // namespace fovea::testing
