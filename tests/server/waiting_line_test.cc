#include "server/scheduling/waiting_line.h"

#include <gtest/gtest.h>

namespace fovea::testing {
namespace {

using server::WaitingLine;
using std::chrono::seconds;

const WaitingLine::Clock::time_point kNow{};

TEST(WaitingLine, CountsWhoCameBefore) {
  WaitingLine line(10);
  EXPECT_EQ(line.Ahead("a", kNow), 0);
  line.Keep("a", kNow + seconds(1));
  line.Keep("b", kNow + seconds(1));
  EXPECT_EQ(line.Ahead("a", kNow), 0);
  EXPECT_EQ(line.Ahead("b", kNow), 1);
  EXPECT_EQ(line.Ahead("c", kNow), 2);
  line.Keep("a", kNow + seconds(1));  // again: the same place
  EXPECT_EQ(line.Ahead("b", kNow), 1);
  line.Leave("a");
  EXPECT_EQ(line.Ahead("b", kNow), 0);
  EXPECT_EQ(line.Ahead("c", kNow), 1);
}

TEST(WaitingLine, DropsWhoDoesNotComeBack) {
  WaitingLine line(10);
  line.Keep("late", kNow + seconds(1));
  line.Keep("b", kNow + seconds(3));
  EXPECT_EQ(line.Ahead("b", kNow + seconds(1)), 1);
  EXPECT_EQ(line.Ahead("b", kNow + seconds(2)), 0);
  EXPECT_EQ(line.Ahead("late", kNow + seconds(2)), 1);
  line.Keep("b", kNow + seconds(9));  // comes back in time and stays in line
  EXPECT_EQ(line.Ahead("late", kNow + seconds(8)), 1);
}

TEST(WaitingLine, IsBounded) {
  WaitingLine line(2);
  for (const char* robot : {"a", "b", "c"}) line.Keep(robot, kNow + seconds(1));
  EXPECT_EQ(line.Ahead("c", kNow), 2);
  line.Leave("b");
  EXPECT_EQ(line.Ahead("c", kNow), 1);
}

}  // namespace
}  // namespace fovea::testing
