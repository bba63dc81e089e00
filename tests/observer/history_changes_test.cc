// What becomes of a history when its folder or the clock change.
#include <gmock/gmock.h>

#include "tests/observer/history_fixture.h"

namespace fovea::testing {
namespace {

namespace fs = std::filesystem;
using observer::History;
using std::chrono::seconds;
using ::testing::ElementsAre;

TEST_F(ObserverHistory, AFolderThatWasMovedAwayIsMadeAnewForItsUserAlone) {
  const fs::path folder = folder_.At("history");
  History history(folder, {});
  fs::rename(folder, folder_.At("away"));
  history.Add(Record("arm"), kStart);
  EXPECT_EQ(fs::status(folder).permissions(), fs::perms::owner_all);
  EXPECT_EQ(Files().size(), 1U);
}

TEST_F(ObserverHistory, IsOfOneProgram) {
  const History history(folder_.Path(), {});
  EXPECT_THAT([&] { const History other(folder_.Path(), {}); },
              ::testing::ThrowsMessage<std::runtime_error>(
                  ::testing::HasSubstr("another program uses it")));
}

TEST_F(ObserverHistory, WhatIsInThePlaceOfAFolderThatWasMovedIsTheHistory) {
  const fs::path folder = folder_.At("history"), away = folder_.At("away");
  const fs::path other = folder_.At("other");
  { History(other, {}).Add(Record("hall"), kStart); }
  History history(folder, {});
  history.Add(Record("arm"), kStart);
  fs::rename(folder, away);
  fs::rename(other, folder);
  history.Add(Record("arm"), kStart + seconds(1));
  EXPECT_EQ(IdsOf(history, "arm").size(), 1U) << "the other one is not there any more";
  EXPECT_EQ(IdsOf(history, "hall").size(), 1U);
  EXPECT_EQ(IdsOf(History(away, {}), "arm").size(), 1U) << "others may use it";
  EXPECT_THROW(History(folder, {}), std::runtime_error);
}

TEST_F(ObserverHistory, DoesNotTakeTheFolderOfAnotherProgram) {
  const fs::path folder = folder_.At("history");
  History history(folder, {});
  fs::rename(folder, folder_.At("away"));
  const History other(folder, {});
  EXPECT_THAT([&] { history.Add(Record("arm"), kStart); },
              ::testing::ThrowsMessage<std::runtime_error>(
                  ::testing::HasSubstr("another program uses it")));
  EXPECT_TRUE(Files().empty());
}

TEST_F(ObserverHistory, NumbersGoUpWhateverTheClockDoes) {
  History history(folder_.Path(), {});
  for (const int at : {0, 0, -100, 5}) history.Add(Record("a"), kStart + seconds(at));
  const auto ids = IdsOf(history, "a");
  EXPECT_EQ(ids.size(), 4U);
  EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
}

// By the time that it is set back, so that they lie before those that come.
TEST_F(ObserverHistory, FramesGoBackWithTheClock) {
  History history(folder_.Path(), {.span = seconds(100)});
  for (const int at : {10'000, 10'001}) history.Add(Record("a"), kStart + seconds(at));
  history.Add(Record("b"), kStart + seconds(10'000));
  for (const int at : {0, 1}) history.Add(Record("a"), kStart + seconds(at));
  const std::uint64_t start = 1'700'000'000'000'000, second = 1'000'000;
  EXPECT_THAT(IdsOf(history, "a"), ElementsAre(start - second, start, start + 1, start + second));
  EXPECT_THAT(IdsOf(history, "b"), ElementsAre(start)) << "which has been silent since";
  for (const std::uint64_t id : IdsOf(history, "a")) EXPECT_TRUE(history.Read("a", id));
  EXPECT_EQ(Files().size(), 5U);
}

TEST_F(ObserverHistory, FramesOfAProgramBeforeGoBackWithTheClock) {
  { History(folder_.Path(), {}).Add(Record("a"), kStart + seconds(10'000)); }
  History history(folder_.Path(), {});
  history.Add(Record("b"), kStart);
  EXPECT_THAT(IdsOf(history, "a"), ElementsAre(1'700'000'000'000'000));
}

TEST_F(ObserverHistory, SaysWhyItIsShort) {
  History history(folder_.Path(), {.max_bytes = 100'000});
  int second = 0;
  const auto add = [&](std::size_t bytes) {
    history.Add(Record("a", bytes), kStart + seconds(++second));
  };
  for (int i = 0; i < 8; ++i) add(5000);
  EXPECT_EQ(history.Shortage(), "");
  for (int i = 0; i < 8; ++i) add(5000);
  EXPECT_EQ(history.Shortage(), "holds less than 10 minutes: --history-size is too little");
  second = 600;  // the last one that went did so before the 16th came
  add(10);
  EXPECT_NE(history.Shortage(), "");
  second = 700;
  add(10);
  EXPECT_EQ(history.Shortage(), "");
  std::filesystem::create_symlink(
      "/dev/full", FileOf("a", IdsOf(history, "a").back() + 1'000'000).string() + ".part");
  add(10);
  EXPECT_EQ(history.Shortage(), "holds less than 10 minutes: the disk is full");
}

TEST_F(ObserverHistory, WhatWouldBeBefore1970IsDropped) {
  History history(folder_.Path(), {});
  for (const int at : {0, 10}) history.Add(Record("a"), kStart + seconds(at));
  history.Add(Record("a"), std::chrono::system_clock::time_point(seconds(5)));
  EXPECT_THAT(IdsOf(history, "a"), ElementsAre(5'000'000, 5'000'001));
  EXPECT_EQ(Files().size(), 2U);
}

}  // namespace
}  // namespace fovea::testing
