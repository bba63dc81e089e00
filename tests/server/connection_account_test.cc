#include "server/connections/connection_account.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fovea::testing {
namespace {

using server::AccountLimits;
using server::ConnectionAccount;
using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;
using ::testing::HasSubstr;
using ::testing::Optional;

constexpr std::uint64_t kMiB = 1 << 20;
const ConnectionAccount::Clock::time_point kStart{};

TEST(ConnectionAccount, OwesWhatIsNoMessageYet) {
  ConnectionAccount account(kStart);
  account.OnReceived(3 * kMiB, kStart);
  EXPECT_EQ(account.owed(), 3 * kMiB);
  account.OnMessage(2 * kMiB, kStart);
  EXPECT_LT(account.owed(), kMiB);
  EXPECT_GT(account.owed(), kMiB * 9 / 10);  // the frames around a message are not its bytes
}

TEST(ConnectionAccount, IsNotMisledByACountThatFallsBehind) {
  ConnectionAccount account(kStart);
  account.Admit();
  account.OnReceived(2 * kMiB, kStart);
  account.OnReceived(kMiB, kStart);
  EXPECT_EQ(account.owed(), 2 * kMiB);
  account.OnReceived(3 * kMiB, kStart);
  EXPECT_EQ(account.owed(), 3 * kMiB);
}

TEST(ConnectionAccount, OfARobotThatSendsOnAndOnStaysSmall) {
  constexpr int kFrames = 100'000;
  constexpr std::uint64_t kFrame = 1'500'000, kOnTheWire = 1'504'000;  // with TLS and HTTP/2
  ConnectionAccount account(kStart);
  account.Admit();
  for (int i = 1; i <= kFrames; ++i) {
    const auto now = kStart + i * milliseconds(33);
    account.OnReceived(static_cast<std::uint64_t>(i) * kOnTheWire, now);
    account.OnMessage(kFrame, now);
    ASSERT_EQ(account.Fault({}, now), std::nullopt) << i;
  }
  EXPECT_EQ(account.owed(), 0U);
}

TEST(ConnectionAccount, MayBeAskedForItsHealthForEver) {
  ConnectionAccount account(kStart);
  account.Admit();
  for (int second = 1; second <= 100'000; ++second) {
    account.OnReceived(static_cast<std::uint64_t>(second) * 300, kStart + seconds(second));
  }
  EXPECT_EQ(account.owed(), 0U);
}

// Each message that it takes is answered by an update of its window, and a ping at times.
TEST(ConnectionAccount, MayBeSentAsMuchAsItTakes) {
  constexpr std::uint64_t kReplies = 60 * 50;  // within a second
  ConnectionAccount account(kStart);
  account.Admit();
  for (std::uint64_t second = 1; second <= 10'000; ++second) {
    const auto now = kStart + std::chrono::seconds(second);
    for (int message = 0; message < 60; ++message) account.OnSent(100);
    account.OnReceived(second * kReplies, now);
    ASSERT_EQ(account.owed(), 0U) << second;
  }
}

TEST(ConnectionAccount, MayBeSentOnAndOnAndOwesAllTheSame) {
  ConnectionAccount account(kStart);
  account.Admit();
  for (int message = 0; message < 1'000'000; ++message) account.OnSent(1000);
  account.OnReceived(65 * kMiB, kStart);
  EXPECT_THAT(account.Fault({.max_owed = 64 * kMiB}, kStart), Optional(HasSubstr("no message")));
}

TEST(ConnectionAccount, EndsWhereAMessageDoesNotComeInTime) {
  const AccountLimits limits{.max_owed = 64 * kMiB, .max_transfer = seconds(30)};
  ConnectionAccount account(kStart);
  account.Admit();
  account.OnReceived(kMiB, kStart);
  EXPECT_EQ(account.Fault(limits, kStart + seconds(30)), std::nullopt);
  EXPECT_THAT(account.Fault(limits, kStart + seconds(31)), Optional(HasSubstr("in 30 s")));
}

TEST(ConnectionAccount, AnIdleStreamMayTakeItsTimeForTheNextFrame) {
  const AccountLimits limits{.max_owed = 64 * kMiB, .max_transfer = seconds(30)};
  ConnectionAccount account(kStart);
  account.Admit();
  account.OnReceived(kMiB, kStart + minutes(60));
  EXPECT_EQ(account.Fault(limits, kStart + minutes(60) + seconds(29)), std::nullopt);
}

TEST(ConnectionAccount, EndsWhereItHoldsTooMuch) {
  ConnectionAccount account(kStart);
  account.Admit();
  account.OnReceived(65 * kMiB, kStart);
  EXPECT_THAT(account.Fault({.max_owed = 64 * kMiB}, kStart), Optional(HasSubstr("no message")));
}

TEST(ConnectionAccount, OfAStrangerMayHoldLittle) {
  ConnectionAccount account(kStart);
  account.OnReceived(kMiB, kStart);
  EXPECT_EQ(account.Fault({}, kStart), std::nullopt);
  account.OnReceived(kMiB + 1, kStart);
  EXPECT_THAT(account.Fault({}, kStart), Optional(HasSubstr("no call let in")));
  account.Admit();
  EXPECT_EQ(account.Fault({}, kStart), std::nullopt);
}

TEST(ConnectionAccount, OfAStrangerLivesTenMinutes) {
  const ConnectionAccount account(kStart);
  EXPECT_EQ(account.Fault({}, kStart + minutes(10)), std::nullopt);
  EXPECT_THAT(account.Fault({}, kStart + minutes(11)), Optional(HasSubstr("10 minutes")));
}

TEST(ConnectionAccount, CallsThatWereRefusedAreGivenBack) {
  constexpr std::uint64_t kUnread = 64 << 10;
  ConnectionAccount account(kStart);
  account.Admit();
  std::uint64_t total = 0;
  for (int call = 0; call < 1000; ++call) {
    const std::uint64_t since = account.BeginReading();
    account.OnReceived(total += kUnread / 2, kStart);
    account.Forgive(since);
    account.OnReceived(total += kUnread / 2, kStart);  // until the caller hears of it
  }
  EXPECT_EQ(account.owed(), 0U);
}

TEST(ConnectionAccount, CallsThatEndClearNothingOfThoseThatRead) {
  ConnectionAccount account(kStart);
  account.Admit();
  std::uint64_t total = 0;
  for (int call = 0; call < 40; ++call) {
    const std::uint64_t idle = account.BeginReading();
    account.BeginReading();
    account.OnReceived(total += 20 * kMiB, kStart);  // of the other
    account.Forgive(idle);
  }
  EXPECT_GE(account.owed(), 40 * 20 * kMiB);
  EXPECT_THAT(account.Fault({}, kStart), Optional(HasSubstr("no message")));
}

TEST(ConnectionAccount, CallsThatEndLeaveNothingForOthersToSendLate) {
  ConnectionAccount account(kStart);
  account.Admit();
  account.BeginReading();
  for (std::uint64_t call = 1; call <= 1024; ++call) {
    account.Forgive(account.BeginReading());
    account.OnReceived(call * kMiB / 8, kStart);
  }
  EXPECT_GE(account.owed(), 128 * kMiB);
}

TEST(ConnectionAccount, OwesNoLessTimeByCallsThatEnd) {
  ConnectionAccount account(kStart);
  account.Admit();
  account.BeginReading();
  for (int second = 1; second <= 31; ++second) {
    const std::uint64_t idle = account.BeginReading();
    account.OnReceived(static_cast<std::uint64_t>(second) * kMiB, kStart + seconds(second));
    account.Forgive(idle);
    account.OnReceived(static_cast<std::uint64_t>(second) * kMiB, kStart + seconds(second));
  }
  EXPECT_EQ(account.Owing(kStart + seconds(31)), seconds(30));
}

// Of a robot's stream that goes on and on.
TEST(ConnectionAccount, WhatACallLeftIsGivenBackOnceOthersHaveTheirMessages) {
  constexpr std::uint64_t kFrame = 1'500'000;
  ConnectionAccount account(kStart);
  account.Admit();
  std::uint64_t total = 0, stream = account.BeginReading();
  for (int frame = 0; frame < 1000; ++frame) {
    const std::uint64_t call = account.BeginReading();
    account.OnReceived(total += kFrame, kStart);
    account.Forgive(call);  // it had sent all but the whole
    account.OnReceived(total += kFrame, kStart);
    account.OnMessage(kFrame, kStart);
    account.EndReading(stream);
    stream = account.BeginReading();
    ASSERT_LT(account.owed(), kMiB) << frame;
  }
}

TEST(ConnectionAccount, CallsCountWithinASecond) {
  ConnectionAccount account(kStart);
  account.Admit();
  std::uint64_t total = 0;
  for (int second = 0; second < 60; ++second) {
    account.OnBegunCalls(total += 1000, 1000, kStart + milliseconds(1001) * second);
    EXPECT_EQ(account.Fault({}, kStart), std::nullopt) << second;
  }
  account.OnBegunCalls(total += 1'000'000, 1000, kStart + minutes(60));  // not looked at before
  EXPECT_EQ(account.Fault({}, kStart), std::nullopt);
  account.OnBegunCalls(total + 1001, 1000, kStart + minutes(60) + milliseconds(10));
  EXPECT_THAT(account.Fault({}, kStart), Optional(HasSubstr("began 1001 calls")));
  EXPECT_TRUE(account.IsFlooding());
}

TEST(ConnectionAccount, HoldsWhatItOwesAllTheTime) {
  ConnectionAccount robot(kStart), other(kStart);
  std::uint64_t total = 0;
  for (int i = 1; i <= 100; ++i) {
    const auto now = kStart + i * milliseconds(100);
    robot.OnReceived(total += kMiB, now);
    robot.OnMessage(kMiB, now);
    robot.OnReceived(total += kMiB, now);
    other.OnReceived(10 * kMiB, now);
    if (i < 100) robot.OnMessage(kMiB, now);
  }
  EXPECT_GE(robot.owed(), kMiB * 9 / 10);
  EXPECT_EQ(robot.held(), 0U);
  EXPECT_GT(other.held(), 9 * kMiB);
}

}  // namespace
}  // namespace fovea::testing
