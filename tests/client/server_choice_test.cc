#include "client/server_choice.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace fovea::client {
namespace {

using std::chrono::milliseconds;

const ServerChoice::Clock::time_point kNow =
    ServerChoice::Clock::time_point{} + std::chrono::hours(1);

// The one of "a" and "b" that is not `name`.
std::string Other(const std::string& name) { return name == "a" ? "b" : "a"; }

class ChoiceOfTwo : public ::testing::Test {
 protected:
  ChoiceOfTwo() { choice_.SetServers({"a", "b"}); }

  ServerRound Round(bool asks_others = true) { return {choice_, asks_others}; }
  std::string Home() { return choice_.Home(kNow); }

  ServerChoice choice_{1};
};

TEST_F(ChoiceOfTwo, AClientStaysWithItsServer) {
  const std::string home = Home();
  for (int call = 0; call < 10; ++call) {
    ServerRound round = Round();
    EXPECT_EQ(round.Next(kNow)->server, home);
    round.OnAnswered();
  }
}

TEST_F(ChoiceOfTwo, ClientsAreSpread) {
  std::set<std::string> homes;
  for (unsigned seed = 0; seed < 20; ++seed) {
    ServerChoice choice(seed);
    choice.SetServers({"a", "b"});
    homes.insert(choice.Home(kNow));
  }
  EXPECT_EQ(homes.size(), 2U);
}

TEST_F(ChoiceOfTwo, AllAreAskedForRoomBeforeOneKeepsAPlace) {
  const std::string home = Home();
  ServerRound round = Round();
  const auto first = round.Next(kNow);
  EXPECT_EQ(first->server, home);
  EXPECT_TRUE(first->only_if_room);
  round.OnRefused(milliseconds(100));
  const auto second = round.Next(kNow);
  EXPECT_EQ(second->server, Other(home));
  EXPECT_TRUE(second->only_if_room);
  round.OnRefused(milliseconds(100));
  EXPECT_FALSE(round.wait());
  const auto last = round.Next(kNow);
  EXPECT_EQ(last->server, home);
  EXPECT_FALSE(last->only_if_room);
  round.OnRefused(milliseconds(110));
  EXPECT_FALSE(round.Next(kNow));
  EXPECT_EQ(round.wait(), milliseconds(110));
  EXPECT_EQ(Home(), home);
}

TEST_F(ChoiceOfTwo, WhoWaitsInLineAsksOnlyThere) {
  ServerRound round = Round(/*asks_others=*/false);
  EXPECT_FALSE(round.Next(kNow)->only_if_room);
  round.OnRefused(milliseconds(100));
  EXPECT_FALSE(round.Next(kNow));
}

TEST_F(ChoiceOfTwo, EverySecondCallThatGetsAPlaceAsksAll) {
  for (const bool asks_all : {true, false, true, false}) {
    ServerRound round = Round();
    EXPECT_EQ(round.Next(kNow)->only_if_room, asks_all);
    round.OnRefused(milliseconds(100));
    while (round.Next(kNow)) round.OnRefused(milliseconds(100));
    EXPECT_TRUE(round.wait());
    ServerRound again = Round(/*asks_others=*/false);  // changes nothing
    again.Next(kNow);
    again.OnRefused(milliseconds(100));
  }
}

TEST_F(ChoiceOfTwo, MovesToWhereItIsSooner) {
  const std::string home = Home();
  ServerRound round = Round();
  round.Next(kNow);
  round.OnRefused(milliseconds(100));
  round.Next(kNow);
  round.OnRefused(milliseconds(99));
  const auto moved = round.Next(kNow);  // for a place in line
  EXPECT_EQ(moved->server, Other(home));
  EXPECT_FALSE(moved->only_if_room);
  round.OnRefused(milliseconds(105));
  EXPECT_FALSE(round.Next(kNow));
  EXPECT_EQ(round.wait(), milliseconds(105));
  EXPECT_EQ(Home(), Other(home));
}

TEST_F(ChoiceOfTwo, MovesToWhoeverAnswersTwiceInARow) {
  const std::string home = Home();
  for (int call = 0; call < 2; ++call) {
    EXPECT_EQ(Home(), home);
    ServerRound round = Round();
    round.Next(kNow);
    round.OnRefused(milliseconds(100));
    round.Next(kNow);
    round.OnAnswered();
  }
  EXPECT_EQ(Home(), Other(home));
}

TEST_F(ChoiceOfTwo, LeavesWhoIsAwayAndReturnsForAReasonOnly) {
  const std::string home = Home();
  ServerRound round = Round();
  round.Next(kNow);
  round.OnAway(kNow);
  const auto next = round.Next(kNow);
  EXPECT_EQ(next->server, Other(home));
  EXPECT_FALSE(next->only_if_room);  // there is nobody else
  round.OnAnswered();
  EXPECT_EQ(choice_.Home(kNow + std::chrono::hours(1)), Other(home));
}

TEST_F(ChoiceOfTwo, AsksEachOnceWhereAllAreAway) {
  ServerRound round = Round();
  for (int ask = 0; ask < 2; ++ask) {
    EXPECT_TRUE(round.Next(kNow));
    round.OnAway(kNow);
  }
  EXPECT_FALSE(round.Next(kNow));
  EXPECT_FALSE(round.wait());
  EXPECT_TRUE(choice_.AreAllAway(kNow));
  EXPECT_FALSE(choice_.AreAllAway(kNow + milliseconds(100)));
  ServerRound again = Round();  // they may be back all the same
  EXPECT_TRUE(again.Next(kNow));
}

TEST_F(ChoiceOfTwo, AsksNobodyAsideWhoIsAway) {
  choice_.OnAway(Other(Home()), kNow);
  ServerRound round = Round();
  EXPECT_FALSE(round.Next(kNow)->only_if_room);
  round.OnRefused(milliseconds(100));
  EXPECT_FALSE(round.Next(kNow));
}

TEST_F(ChoiceOfTwo, AreAwayForTwiceAsLongEachTime) {
  for (const int ms : {100, 200, 400, 800, 1600, 3200, 5000, 5000}) {
    choice_.OnAway("a", kNow);
    EXPECT_TRUE(choice_.IsAway("a", kNow + milliseconds(ms - 1)));
    EXPECT_FALSE(choice_.IsAway("a", kNow + milliseconds(ms)));
  }
  choice_.OnAnswered("a");
  EXPECT_FALSE(choice_.IsAway("a", kNow));
}

TEST_F(ChoiceOfTwo, ChoosesAnewWhereTheConnectionEndsOrServersChange) {
  std::set<std::string> homes;
  for (int times = 0; times < 20; ++times) {
    homes.insert(Home());
    choice_.OnDisconnected(Home());
  }
  EXPECT_EQ(homes.size(), 2U);
  const std::string home = Home();
  choice_.SetServers({"b", "a"});
  EXPECT_EQ(Home(), home);
  choice_.SetServers({"c"});
  EXPECT_EQ(Home(), "c");
}

TEST(ServerChoice, AsksThreeOthersAtMost) {
  ServerChoice choice(1);
  choice.SetServers({"a", "b", "c", "d", "e", "f"});
  ServerRound round(choice, /*asks_others=*/true);
  std::set<std::string> asked;
  int asks = 0;
  while (const auto ask = round.Next(kNow)) {
    ++asks;
    asked.insert(ask->server);
    round.OnRefused(milliseconds(100));
  }
  EXPECT_EQ(asked.size(), 4U);
  EXPECT_EQ(asks, 5);  // the last one for a place
}

TEST(ServerChoice, AsksNobodyWhereThereIsNone) {
  ServerChoice choice(1);
  EXPECT_FALSE(ServerRound(choice, /*asks_others=*/true).Next(kNow));
}

}  // namespace
}  // namespace fovea::client
