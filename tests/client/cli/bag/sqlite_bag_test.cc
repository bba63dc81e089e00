#include "client/cli/bag/sqlite_bag.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "client/cli/bag/bag_files.h"
#include "tests/client/cli/bag/small_bags.h"
#include "tests/client/cli/bag/sqlite_writer.h"
#include "tests/support/bag_writer.h"
#include "tests/support/temporary_folder.h"

namespace fovea::cli::small_bags {
namespace {

using testing::CameraInfoMessage;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::ImageMessage;
using testing::TemporaryFolder;

void AddFrame(std::int64_t time_ns, SqliteWriter* writer) {
  writer->Add(kColor, "Image", ImageMessage(time_ns, "rgb8", 2, 1, 6, kRgb));
  writer->Add(kDepth, "Image", ImageMessage(time_ns, "16UC1", 2, 1, 4, kUnits));
}

std::string WhyNotOpened(const std::string& path) {
  try {
    OpenBag(path, {});
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(SqliteBag, HasFramesOfWhatWasTakenTogether) {
  const TemporaryFolder folder;
  {
    SqliteWriter writer(folder.At("b.db3"));
    writer.Add("/camera/color/camera_info", "CameraInfo", CameraInfoMessage(2, 1, 525, -0.25));
    writer.Add("/chatter", "String", "anything");
    AddFrame(kFirst_ns, &writer);
    AddFrame(kFirst_ns + 500 * kMillisecond_ns, &writer);
  }
  const Bag bag = OpenBag(folder.At("b.db3"), {});
  EXPECT_EQ(bag.color_topic, kColor);
  EXPECT_EQ(bag.depth_topic, kDepth);
  EXPECT_THAT(bag.list.notes, ::testing::IsEmpty());
  ASSERT_EQ(bag.list.frames.size(), 2U);
  const FrameFiles& frame = bag.list.frames.front();
  EXPECT_EQ(frame.id, "1700000000.250000000");
  EXPECT_EQ(frame.color_path, folder.At("b.db3") + ": image 1 of " + kColor);
  EXPECT_EQ(Color(frame).at<cv::Vec3b>(0, 0), cv::Vec3b(0, 0, 255));
  EXPECT_EQ(Depth(frame).at<std::uint16_t>(0, 1), 2500);
  ASSERT_TRUE(ColorCameraOf(bag));
  EXPECT_EQ(ColorCameraOf(bag)->fx, 525);
}

// By the recorder, which has no time of its own in the header.
TEST(SqliteBag, ImagesWithoutTimesHaveThoseOfTheRecorder) {
  const TemporaryFolder folder;
  {
    SqliteWriter writer(folder.At("b.db3"));
    AddFrame(0, &writer);
  }
  EXPECT_EQ(OpenBag(folder.At("b.db3"), {}).list.frames.at(0).id, "2.000000000");
}

TEST(SqliteBag, SaysWhyItIsNone) {
  const TemporaryFolder folder;
  folder.Write("text.db3", "no database, but long enough that it might be one");
  EXPECT_THAT(WhyNotOpened(folder.At("text.db3")), HasSubstr("db3: it is no SQLite database"));
  folder.Write("empty.db3", "");
  EXPECT_THAT(WhyNotOpened(folder.At("empty.db3")), HasSubstr("it has no tables topics and"));
  EXPECT_THAT(WhyNotOpened(folder.At("away.db3")), HasSubstr("db3: there is no such file"));
  {
    SqliteWriter writer(folder.At("other.db3"));
    writer.Run("DROP TABLE messages");
    writer.Run("CREATE TABLE messages(id INTEGER PRIMARY KEY, text TEXT)");
  }
  EXPECT_THAT(WhyNotOpened(folder.At("other.db3")), HasSubstr("no such column: topic_id"));
}

// Which SQLite would have to undo, and write for that.
TEST(SqliteBag, WithAJournalOfItsRecorderSaysWhatHelps) {
  const TemporaryFolder folder;
  SqliteWriter writer(folder.At("open.db3"));
  AddFrame(kFirst_ns, &writer);
  writer.Run("PRAGMA journal_mode = DELETE; PRAGMA cache_size = 1; BEGIN");
  writer.Run("INSERT INTO messages VALUES(NULL, 1, 1, zeroblob(3000000))");
  for (const char* file : {"db3", "db3-journal"}) {
    std::filesystem::copy(folder.At("open.") + file, folder.At("killed.") + file);
  }
  writer.Run("ROLLBACK");
  EXPECT_THAT(WhyNotOpened(folder.At("killed.db3")), HasSubstr("sqlite3 FILE .schema"));
}

// A question that never ends, in the place of a table.
TEST(SqliteBag, AsksNoViews) {
  const TemporaryFolder folder;
  {
    SqliteWriter writer(folder.At("b.db3"));
    writer.Run("DROP TABLE messages");
    writer.Run(
        "CREATE VIEW messages AS WITH RECURSIVE n(id) AS (SELECT 1 UNION ALL SELECT id + 1 FROM "
        "n) SELECT id, 1 AS topic_id, 1 AS timestamp, x'00' AS data FROM n");
  }
  EXPECT_THAT(WhyNotOpened(folder.At("b.db3")), HasSubstr("it has no tables topics and messages"));
}

TEST(SqliteBag, OfADamagedOneIsReadWhatCanBe) {
  constexpr std::size_t kPage = 4096;
  const TemporaryFolder folder;
  const std::string path = folder.At("b.db3");
  {
    SqliteWriter writer(path);
    for (int i = 0; i < 200; ++i) AddFrame(kFirst_ns + i * 100 * kMillisecond_ns, &writer);
  }
  std::string bytes = ReadFile(path);
  // A leaf of the tree of messages: the last page that holds one.
  const std::size_t page = bytes.rfind(kUnits) / kPage * kPage;
  bytes.replace(page, kPage, std::string(kPage, '\x55'));
  const Bag bag = OpenBag(folder.Write("b.db3", bytes), {});
  EXPECT_GT(bag.list.frames.size(), 50U);
  EXPECT_LT(bag.list.frames.size(), 200U);
  EXPECT_THAT(bag.list.notes,
              ::testing::Contains(HasSubstr("b.db3 cannot be read behind its message")));
  EXPECT_EQ(Depth(bag.list.frames.back()).at<std::uint16_t>(0, 0), 1000);
}

TEST(SqliteBag, ThatIsShortenedMeanwhileFailsItsFrames) {
  const TemporaryFolder folder;
  const std::string path = folder.At("b.db3");
  {
    SqliteWriter writer(path);
    AddFrame(kFirst_ns, &writer);
  }
  const Bag bag = OpenBag(path, {});
  EXPECT_EQ(Color(bag.list.frames.at(0)).cols, 2);
  std::filesystem::resize_file(path, 0);
  EXPECT_THROW(bag.list.frames.at(0).read_color(), std::invalid_argument);
}

}  // namespace
}  // namespace fovea::cli::small_bags
