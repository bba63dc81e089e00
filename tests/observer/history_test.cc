// The history on disk: bounds, and what is left of files that are not whole.
#include <gmock/gmock.h>

#include <fstream>

#include "client/bundle/bundle.h"
#include "client/observer/history/bundling.h"
#include "tests/observer/history_fixture.h"

namespace fovea::testing {
namespace {

namespace fs = std::filesystem;
using observer::History;
using observer::HistoryRecord;
using std::chrono::seconds;

TEST_F(ObserverHistory, IsThereAgain) {
  std::vector<std::uint64_t> ids;
  {
    History history(folder_.Path(), {});
    for (int i = 0; i < 3; ++i) history.Add(Record("hall/..\x7f"), kStart + seconds(i));
    ids = IdsOf(history, "hall/..\x7f");
    ASSERT_EQ(ids.size(), 3U);
  }
  const History history(folder_.Path(), {});
  EXPECT_EQ(IdsOf(history, "hall/..\x7f"), ids);
  const auto record = history.Read("hall/..\x7f", ids[1]);
  ASSERT_TRUE(record);
  EXPECT_EQ(record->header.server, "here:1");
  EXPECT_EQ(record->frame.picture(), std::string(100, 'x'));
  EXPECT_FALSE(history.Read("hall", ids[1]));
  EXPECT_FALSE(history.Read("hall/..\x7f", ids[1] + 1));
}

TEST_F(ObserverHistory, EndsSomeTimeBeforeTheNewestFrame) {
  History history(folder_.Path(), {.span = seconds(10)});
  for (int i = 0; i < 20; ++i) history.Add(Record("a"), kStart + seconds(i));
  history.Add(Record("b"), kStart + seconds(1000));
  EXPECT_EQ(IdsOf(history, "a").size(), 11U);  // silent since then
  EXPECT_EQ(Files().size(), 12U);
}

TEST_F(ObserverHistory, IsBoundedByRobotAndInAll) {
  constexpr std::uint64_t kMost = 100'000;
  History history(folder_.Path(), {.max_bytes = kMost});
  for (int i = 0; i < 100; ++i) history.Add(Record("a", 5000), kStart + seconds(i));
  EXPECT_LE(history.counts().bytes, kMost / 2);
  for (int i = 100; i < 200; ++i) {
    for (const char* robot : {"b", "c", "d"}) history.Add(Record(robot, 5000), kStart + seconds(i));
  }
  EXPECT_LE(history.counts().bytes, kMost);
  EXPECT_THAT(IdsOf(history, "a"), ::testing::IsEmpty());  // the oldest
  std::uint64_t on_disk = 0;
  for (const fs::path& path : Files()) on_disk += fs::file_size(path);
  EXPECT_EQ(on_disk, history.counts().bytes);
}

// The device says what a full disk says, until the file is removed that leads there.
TEST_F(ObserverHistory, TheOldestGoesWhereTheDiskIsFull) {
  History history(folder_.Path(), {});
  for (const int at : {0, 1}) history.Add(Record("a"), kStart + seconds(at));
  history.Add(Record("b"), kStart + seconds(2));
  const auto ids = IdsOf(history, "a");
  const std::uint64_t id = IdsOf(history, "b").front() + 1'000'000;
  const auto path = FileOf("b", id);
  fs::create_symlink("/dev/full", path.string() + ".part");
  history.Add(Record("b"), kStart + seconds(3));
  EXPECT_THAT(IdsOf(history, "a"), ::testing::ElementsAre(ids[1]));
  EXPECT_EQ(IdsOf(history, "b").back(), id);
  EXPECT_TRUE(history.Read("b", id));
}

TEST_F(ObserverHistory, WhyItCannotBeWrittenIsTheSameForAllFiles) {
  History history(folder_.Path(), {});
  history.Add(Record("a"), kStart);
  const auto why = [&](std::uint64_t at) -> std::string {
    fs::create_directory(FileOf("a", IdsOf(history, "a").front() + at * 1'000'000).string() +
                         ".part");
    try {
      history.Add(Record("a"), kStart + seconds(at));
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  };
  const std::string first = why(1);
  EXPECT_THAT(first, ::testing::HasSubstr(folder_.Path()));
  EXPECT_EQ(first, why(2));
  EXPECT_EQ(IdsOf(history, "a").size(), 1U);
}

TEST_F(ObserverHistory, FramesAndRobotsAreBounded) {
  History history(folder_.Path(), {.max_frames = 10, .max_robots = 3});
  for (int i = 0; i < 30; ++i) {
    history.Add(Record("robot" + std::to_string(i / 6)), kStart + seconds(i));
    EXPECT_LE(history.counts().frames, 10U);
    EXPECT_LE(history.counts().robots, 3U);
  }
  EXPECT_EQ(IdsOf(history, "robot4").size(), 6U);
  EXPECT_EQ(Files().size(), history.counts().frames);
}

TEST_F(ObserverHistory, BoundsHoldForWhatIsThere) {
  {
    History history(folder_.Path(), {});
    for (int i = 0; i < 20; ++i) history.Add(Record("a", 5000), kStart + seconds(i));
  }
  const History history(folder_.Path(), {.span = seconds(5)});
  EXPECT_EQ(IdsOf(history, "a").size(), 6U);
  EXPECT_EQ(Files().size(), 6U);
}

TEST_F(ObserverHistory, WhatIsNotWholeIsDropped) {
  {
    History history(folder_.Path(), {});
    for (int i = 0; i < 5; ++i) history.Add(Record("a"), kStart + seconds(i));
  }
  const std::vector<fs::path> files = Files();
  fs::resize_file(files[0], fs::file_size(files[0]) - 1);
  fs::resize_file(files[1], 3);
  std::fstream(files[2]) << "something else";
  const fs::path part = files[3].string() + ".part";
  std::ofstream(part) << "half";
  History history(folder_.Path(), {});
  EXPECT_EQ(IdsOf(history, "a").size(), 2U);
  EXPECT_EQ(Files().size(), 2U);
  EXPECT_FALSE(fs::exists(part));
}

TEST_F(ObserverHistory, WhatIsDamagedInsideIsNotShown) {
  History history(folder_.Path(), {});
  history.Add(Record("a"), kStart);
  const std::uint64_t id = IdsOf(history, "a").front();
  ASSERT_TRUE(history.Read("a", id));
  std::fstream file(Files().front(), std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(-1, std::ios::end).put('y');
  file.close();
  EXPECT_FALSE(history.Read("a", id));
}

TEST_F(ObserverHistory, FilesOfAnotherRobotInItsFolderAreNone) {
  {
    History history(folder_.Path(), {});
    history.Add(Record("a"), kStart);
    history.Add(Record("b"), kStart);
  }
  const fs::path stolen = Files().front();
  fs::rename(stolen, fs::path(folder_.Path()) / "b" / "00000000000000000007.frame");
  const History history(folder_.Path(), {});
  EXPECT_THAT(IdsOf(history, "a"), ::testing::IsEmpty());
  EXPECT_EQ(IdsOf(history, "b").size(), 1U);
}

TEST_F(ObserverHistory, IsListedByServer) {
  History history(folder_.Path(), {});
  history.Add(Record("a", 1, "here:1"), kStart);
  history.Add(Record("a", 1, "there:2"), kStart + seconds(1));
  const auto of_there = history.List("a", [](const auto& server) { return server == "there:2"; });
  ASSERT_EQ(of_there.size(), 1U);
  EXPECT_EQ(of_there[0].server, "there:2");
}

TEST_F(ObserverHistory, RobotsMayHaveAnyName) {
  History history(folder_.Path(), {});
  for (const char* name : {"lock", ".lock", "..", "a/b"}) {
    EXPECT_NO_THROW(history.Add(Record(name), kStart)) << name;
    EXPECT_EQ(IdsOf(history, name).size(), 1U) << name;
  }
}

// As those of certificates may be.
TEST_F(ObserverHistory, RobotsMayHaveLongNames) {
  const std::string one(253, '/'), other = std::string(252, '/') + "x";
  {
    History history(folder_.Path(), {});
    for (const std::string& name : {one, other}) history.Add(Record(name), kStart);
  }
  const History history(folder_.Path(), {});
  for (const std::string& name : {one, other}) {
    const auto ids = IdsOf(history, name);
    ASSERT_EQ(ids.size(), 1U);
    EXPECT_EQ(history.Read(name, ids.front())->header.robot, name);
  }
}

TEST_F(ObserverHistory, BundlesAreBoundedByWhatWasAnsweredToo) {
  History history(folder_.Path(), {});
  HistoryRecord record = Record("a");
  record.frame.mutable_frame()->set_id("small");
  record.frame.mutable_answer()->add_objects()->mutable_cloud()->set_colors(
      std::string(std::size_t{5} << 20, 'x'));
  for (int i = 0; i < 10; ++i) history.Add(record, kStart + seconds(i));
  const auto entries = history.List("a", [](const auto&) { return true; });
  const observer::Moment all{.at = entries.front().id, .before = 0, .after = 600'000'000};
  const auto file = observer::BundleOf(history, "a", entries, all);
  ASSERT_TRUE(file);
  EXPECT_EQ(bundle::Bundle(file->bytes).names().size(), 6U);  // of 32 MiB
}

}  // namespace
}  // namespace fovea::testing
