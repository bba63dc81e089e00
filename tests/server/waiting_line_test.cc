#include "server/scheduling/waiting_line.h"

#include <gtest/gtest.h>

namespace fovea::testing {
namespace {

using server::RobotId;
using server::WaitingLine;
using std::chrono::seconds;

const WaitingLine::Clock::time_point kNow{};

RobotId One(const char* name) { return {"host", name}; }

TEST(WaitingLine, CountsWhoCameBefore) {
  WaitingLine line(10);
  EXPECT_EQ(line.Ahead(One("a"), kNow), 0);
  line.Keep(One("a"), kNow + seconds(1));
  line.Keep(One("b"), kNow + seconds(1));
  EXPECT_EQ(line.Ahead(One("a"), kNow), 0);
  EXPECT_EQ(line.Ahead(One("b"), kNow), 1);
  EXPECT_EQ(line.Ahead(One("c"), kNow), 2);
  line.Keep(One("a"), kNow + seconds(1));  // again: the same place
  EXPECT_EQ(line.Ahead(One("b"), kNow), 1);
  line.Leave(One("a"));
  EXPECT_EQ(line.Ahead(One("b"), kNow), 0);
  EXPECT_EQ(line.Ahead(One("c"), kNow), 1);
}

TEST(WaitingLine, DropsWhoDoesNotComeBack) {
  WaitingLine line(10);
  line.Keep(One("late"), kNow + seconds(1));
  line.Keep(One("b"), kNow + seconds(3));
  EXPECT_EQ(line.Ahead(One("b"), kNow + seconds(1)), 1);
  EXPECT_EQ(line.Ahead(One("b"), kNow + seconds(2)), 0);
  EXPECT_EQ(line.Ahead(One("late"), kNow + seconds(2)), 1);
  line.Keep(One("b"), kNow + seconds(9));  // comes back in time and stays in line
  EXPECT_EQ(line.Ahead(One("late"), kNow + seconds(8)), 1);
}

TEST(WaitingLine, IsBounded) {
  WaitingLine line(2);
  for (const char* robot : {"a", "b", "c"}) line.Keep(One(robot), kNow + seconds(1));
  EXPECT_EQ(line.Ahead(One("c"), kNow), 2);
  line.Leave(One("b"));
  EXPECT_EQ(line.Ahead(One("c"), kNow), 1);
}

TEST(WaitingLine, ManyNamesGetAHostNoFurther) {
  WaitingLine line(10);
  for (const char* name : {"1", "2", "3", "4"}) line.Keep({"many", name}, kNow + seconds(1));
  EXPECT_EQ(line.Ahead({"few", "a"}, kNow), 1U);
  line.Keep({"few", "a"}, kNow + seconds(1));
  EXPECT_EQ(line.Ahead({"few", "b"}, kNow), 3U);  // its own first one, and two of the others
  EXPECT_EQ(line.Ahead({"many", "4"}, kNow), 3U);
  EXPECT_EQ(line.Ahead({"many", "5"}, kNow), 5U);
}

TEST(WaitingLine, WhereItIsFullTheLargestGroupMakesRoom) {
  WaitingLine line(3);
  for (const char* name : {"1", "2", "3"}) line.Keep({"many", name}, kNow + seconds(1));
  line.Keep({"few", "a"}, kNow + seconds(1));
  EXPECT_EQ(line.Ahead({"many", "none"}, kNow), 3U);
  line.Leave({"many", "3"});  // has lost its place
  EXPECT_EQ(line.Ahead({"many", "none"}, kNow), 3U);
  line.Leave({"few", "a"});
  EXPECT_EQ(line.Ahead({"many", "none"}, kNow), 2U);
}

TEST(WaitingLine, ProlongsOnlyPlacesThatThereAre) {
  WaitingLine line(3);
  line.Prolong(One("a"), kNow + seconds(9));
  EXPECT_EQ(line.Ahead(One("b"), kNow), 0U);
  line.Keep(One("a"), kNow + seconds(1));
  line.Prolong(One("a"), kNow + seconds(9));
  EXPECT_EQ(line.Ahead(One("b"), kNow + seconds(8)), 1U);
}

}  // namespace
}  // namespace fovea::testing
