#include "client/server_load.h"

#include <gtest/gtest.h>

namespace fovea::client {
namespace {

// After so many seconds and frames, each of which took half a second, and one in the queue.
v1::GetStatisticsResponse Statistics(int seconds, int num_frames, int num_waiting) {
  v1::GetStatisticsResponse statistics;
  statistics.mutable_uptime()->set_seconds(seconds);
  (*statistics.mutable_frames_answered())["OK"] = static_cast<std::uint64_t>(num_frames);
  statistics.set_frames_waiting(static_cast<std::uint64_t>(num_waiting));
  auto& stages = *statistics.mutable_stages();
  stages["queue"].mutable_total()->set_seconds(num_frames);
  for (const char* stage : {"decode", "mrf"}) {
    const int total_ms = num_frames * 250;
    stages[stage].mutable_total()->set_seconds(total_ms / 1000);
    stages[stage].mutable_total()->set_nanos(total_ms % 1000 * 1'000'000);
  }
  return statistics;
}

TEST(ServerLoad, SaysHowOftenRobotsGetAnswersThatTakeTurns) {
  ServerLoad load;
  load.Note(Statistics(100, 50, 3));
  EXPECT_FALSE(load.Turn(0));
  load.Note(Statistics(110, 90, 7));
  EXPECT_TRUE(load.is_overloaded());
  EXPECT_DOUBLE_EQ(*load.Turn(0), 2.0);  // eight at four frames a second
  EXPECT_DOUBLE_EQ(*load.Turn(1), 2.25);
}

TEST(ServerLoad, GoesByTheWorkOfAFrameWhereNothingWaits) {
  ServerLoad load;
  load.Note(Statistics(100, 50, 0));
  load.Note(Statistics(110, 54, 0));
  EXPECT_FALSE(load.is_overloaded());
  EXPECT_DOUBLE_EQ(*load.Turn(1), 1.0);
}

TEST(ServerLoad, WhoHadNothingToDoAnswersAtOnce) {
  ServerLoad load;
  load.Note(Statistics(100, 50, 0));
  load.Note(Statistics(110, 50, 0));
  EXPECT_EQ(load.Turn(1), 0.0);
}

TEST(ServerLoad, KnowsNothingOfWhoHangsOrWasStartedAnew) {
  ServerLoad load;
  load.Note(Statistics(100, 50, 2));
  load.Note(Statistics(110, 50, 2));
  EXPECT_FALSE(load.Turn(1));
  load.Note(Statistics(5, 60, 2));
  EXPECT_FALSE(load.Turn(1));
  load.Note(Statistics(15, 80, 1));
  EXPECT_DOUBLE_EQ(*load.Turn(0), 1.0);
}

}  // namespace
}  // namespace fovea::client
