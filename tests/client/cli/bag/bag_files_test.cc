// Folders as `ros2 bag record` makes them.
#include "client/cli/bag/bag_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "tests/client/cli/bag/bag_folder.h"
#include "tests/client/cli/bag/small_bags.h"
#include "tests/support/bag_writer.h"

namespace fovea::cli::small_bags {
namespace {

using ::testing::HasSubstr;
using testing::ImageMessage;

std::string McapOfFrame(std::int64_t time_ns) {
  return BagOf("Image", ImageMessage(time_ns, "rgb8", 2, 1, 6, kRgb), "Image",
               ImageMessage(time_ns, "16UC1", 2, 1, 4, kUnits));
}

std::string Metadata(const std::string& files) {
  return "rosbag2_bagfile_information:\n  version: 5\n  relative_file_paths:\n" + files;
}

TEST_F(BagFolder, HasTheFramesOfAllItsFiles) {
  Write("metadata.yaml", Metadata("    - part_a.mcap\n    - part_b.mcap\n"));
  Write("part_a.mcap", McapOfFrame(kFirst_ns));
  Write("part_b.mcap", McapOfFrame(kFirst_ns + 500 * kMillisecond_ns));
  Write("part_c.mcap", "of another bag");
  for (const std::string& path : {folder_.At("walk"), folder_.At("walk/")}) {
    ASSERT_TRUE(IsBag(path));
    const Bag bag = OpenBag(path, {});
    ASSERT_EQ(bag.list.frames.size(), 2U);
    EXPECT_THAT(bag.list.frames[1].depth_path, HasSubstr("walk/part_b.mcap: image 2 of /depth"));
    EXPECT_EQ(Depth(bag.list.frames[1]).at<std::uint16_t>(0, 0), 1000);
  }
}

// Its files have the folder's name.
TEST_F(BagFolder, IsOneWithoutMetadataWhereTheRecorderWasKilled) {
  EXPECT_FALSE(IsBag(folder_.At("walk")));
  Write("walk_0.mcap", McapOfFrame(kFirst_ns));
  Write("walk_1.mcap", McapOfFrame(kFirst_ns + 500 * kMillisecond_ns));
  for (const std::string& path : {folder_.At("walk"), folder_.At("walk/")}) {
    ASSERT_TRUE(IsBag(path));
    EXPECT_EQ(OpenBag(path, {}).list.frames.size(), 2U);
  }
}

// Of which "." and a link do not say it.
TEST_F(BagFolder, IsOneWhateverItIsCalledAs) {
  Write("walk_0.mcap", McapOfFrame(kFirst_ns));
  std::filesystem::create_directory(At("inside"));
  std::filesystem::create_directory_symlink(folder_.At("walk"), folder_.At("newest"));
  for (const std::string& path : {At("."), At("./"), At("inside/.."), folder_.At("newest")}) {
    ASSERT_TRUE(IsBag(path)) << path;
    EXPECT_EQ(OpenBag(path, {}).list.frames.size(), 1U);
  }
}

TEST_F(BagFolder, SaysWhichFileIsMissingOrOfAnotherKind) {
  Write("metadata.yaml", Metadata("    - a.mcap\n"));
  EXPECT_EQ(WhyNotOpened(), At("a.mcap") + ": there is no such file");
  Write("metadata.yaml", Metadata("    - a.db3.zstd\n"));
  EXPECT_THAT(WhyNotOpened(),
              HasSubstr("a.db3.zstd is neither .mcap nor .db3; what is compressed"));
  Write("metadata.yaml", "rosbag2_bagfile_information: 3");
  EXPECT_THAT(WhyNotOpened(), HasSubstr("walk: metadata.yaml"));
  Write("metadata.yaml", "a: [");
  EXPECT_THAT(WhyNotOpened(), HasSubstr("walk: metadata.yaml: "));
}

// A pipe would be waited for, and a device has no end.
TEST_F(BagFolder, HasMetadataInAFile) {
  ASSERT_EQ(mkfifo(At("metadata.yaml").c_str(), S_IRUSR | S_IWUSR), 0);
  EXPECT_THAT(WhyNotOpened(), HasSubstr("metadata.yaml is no regular file"));
  std::filesystem::remove(At("metadata.yaml"));
  std::filesystem::create_symlink("/dev/zero", At("metadata.yaml"));
  EXPECT_THAT(WhyNotOpened(), HasSubstr("metadata.yaml is no regular file"));
}

// Whoever wrote it down.
TEST_F(BagFolder, HasNoFilesOfOtherFolders) {
  folder_.Write("secret.mcap", McapOfFrame(kFirst_ns));
  Write("metadata.yaml", Metadata("    - ../secret.mcap\n"));
  EXPECT_EQ(WhyNotOpened(), At("secret.mcap") + ": there is no such file");
}

}  // namespace
}  // namespace fovea::cli::small_bags
