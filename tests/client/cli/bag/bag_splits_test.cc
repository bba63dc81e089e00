// Folders of bags of which files are missing or damaged.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/client/cli/bag/bag_folder.h"
#include "tests/client/cli/bag/small_bags.h"
#include "tests/client/cli/bag/sqlite_writer.h"
#include "tests/support/bag_writer.h"

namespace fovea::cli::small_bags {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::ImageMessage;

std::string McapOfFrameAt(int number) {
  const std::int64_t time_ns = kFirst_ns + std::int64_t{number} * 100 * kMillisecond_ns;
  return BagOf("Image", ImageMessage(time_ns, "rgb8", 2, 1, 6, kRgb), "Image",
               ImageMessage(time_ns, "16UC1", 2, 1, 4, kUnits));
}

class BagSplits : public BagFolder {
 protected:
  void WriteMetadata(const std::string& names) {
    Write("metadata.yaml",
          "rosbag2_bagfile_information:\n  relative_file_paths: [" + names + "]\n");
  }
  FrameList Frames() const { return OpenBag(folder_.At("walk"), {}).list; }
};

TEST_F(BagSplits, OfWhichOneIsMissingAreReadAndSayWhich) {
  WriteMetadata("walk_0.mcap, walk_1.mcap, walk_2.mcap");
  Write("walk_0.mcap", McapOfFrameAt(0));
  Write("walk_2.mcap", McapOfFrameAt(2));
  const FrameList list = Frames();
  ASSERT_EQ(list.frames.size(), 2U);
  EXPECT_EQ(list.frames[1].id, "1700000000.450000000");
  EXPECT_THAT(list.notes, ElementsAre("of the bag's 3 files 1 cannot be read, and what it has is "
                                      "left out: " +
                                      At("walk_1.mcap") + ": there is no such file"));
}

TEST_F(BagSplits, OfWhichSomeAreNoBagsAreRead) {
  WriteMetadata("walk_0.mcap, walk_1.mcap, walk_2.db3");
  Write("walk_0.mcap", McapOfFrameAt(0));
  Write("walk_1.mcap", "");  // as a recorder leaves it that is killed then
  Write("walk_2.db3", "");
  const FrameList list = Frames();
  EXPECT_EQ(list.frames.size(), 1U);
  EXPECT_THAT(list.notes, ElementsAre(HasSubstr("files 2 cannot be read, and what they have is "
                                                "left out; the first is " +
                                                At("walk_1.mcap") + ": it is no MCAP file")));
}

TEST_F(BagSplits, OfWhichOneIsDamagedAreRead) {
  WriteMetadata("walk_0.mcap, walk_1.db3");
  Write("walk_0.mcap", McapOfFrameAt(0));
  {
    SqliteWriter writer(At("walk_1.db3"));
    writer.Run("DROP TABLE topics");
    writer.Run("CREATE TABLE topics(id INTEGER PRIMARY KEY, text TEXT)");
  }
  const FrameList list = Frames();
  EXPECT_EQ(list.frames.size(), 1U);
  EXPECT_THAT(list.notes, ElementsAre(HasSubstr(At("walk_1.db3") + " cannot be read (no such "
                                                                   "column: name)")));
}

TEST_F(BagSplits, OfWhichNoneCanBeReadAreRefused) {
  WriteMetadata("walk_0.mcap, walk_1.mcap");
  EXPECT_EQ(WhyNotOpened(), At("walk_0.mcap") + ": there is no such file");
  Write("walk_1.mcap", "no bag");
  EXPECT_EQ(WhyNotOpened(), At("walk_0.mcap") + ": there is no such file");
}

// What is missing may be why.
TEST_F(BagSplits, WithoutFramesSayWhatIsMissing) {
  WriteMetadata("walk_0.mcap, walk_1.mcap");
  Write("walk_0.mcap", BagOf("String", "a", "String", "b"));
  EXPECT_THAT(WhyNotOpened(),
              HasSubstr("walk: it has no images of ROS 2; of the bag's 2 files 1 "));
  EXPECT_THAT(WhyNotOpened(), HasSubstr(At("walk_1.mcap") + ": there is no such file"));
}

// Its files are those that have its name.
TEST_F(BagSplits, WithoutMetadataAreReadPastAGap) {
  Write("walk_1.mcap", McapOfFrameAt(1));
  Write("walk_10.mcap", McapOfFrameAt(10));
  Write("walk_9.mcap", McapOfFrameAt(9));
  Write("walk_x.mcap", "of another bag");
  ASSERT_TRUE(IsBag(folder_.At("walk")));
  const FrameList list = Frames();
  ASSERT_EQ(list.frames.size(), 3U);
  EXPECT_THAT(list.frames[2].color_path, HasSubstr("walk_10.mcap: image 3 of /rgb"));
  EXPECT_THAT(list.notes,
              ElementsAre(HasSubstr("of the bag's 11 files 8 cannot be read, and what they have is "
                                    "left out; the first is " +
                                    At("walk_0.mcap") + ": there is no such file")));
}

TEST_F(BagSplits, HaveNumbersThatACounterReaches) {
  Write("walk_0.mcap", McapOfFrameAt(0));
  for (const char* name : {"walk_4000000000.mcap", "walk_-1.mcap", "walk_1x.mcap", "walk_.mcap"}) {
    Write(name, McapOfFrameAt(1));
  }
  EXPECT_EQ(Frames().frames.size(), 1U);
  EXPECT_THAT(Frames().notes, ::testing::IsEmpty());
}

}  // namespace
}  // namespace fovea::cli::small_bags
