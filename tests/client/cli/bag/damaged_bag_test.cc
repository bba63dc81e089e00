// Bags of recorders that were killed, of broken disks and of cameras that send nonsense.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <opencv2/core.hpp>

#include "client/cli/bag/bag_files.h"
#include "tests/client/cli/bag/small_bags.h"
#include "tests/support/bag_writer.h"
#include "tests/support/temporary_folder.h"

namespace fovea::cli::small_bags {
namespace {

using testing::BagWriter;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::ImageMessage;

TEST(DamagedBag, OfARecorderThatWasKilledIsReadUntilThere) {
  BagWriter writer;
  writer.Add("/rgb", "Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb));
  writer.Add("/depth", "Image", ImageMessage(kFirst_ns, "16UC1", 2, 1, 4, kUnits));
  writer.EndChunk("zstd");
  const std::size_t whole = writer.Finish().size();
  writer.Add("/rgb", "Image", ImageMessage(2 * kFirst_ns / 3, "rgb8", 2, 1, 6, kRgb));
  const std::string cut = writer.Finish().substr(0, whole - 20);
  const Bag bag = Read(cut);
  EXPECT_EQ(bag.list.frames.size(), 1U);
  EXPECT_THAT(bag.list.notes, ElementsAre(HasSubstr("b.mcap breaks off at byte ")));
}

// As by a recorder that limits its files, or a disk that loses them.
TEST(DamagedBag, ThatIsShortenedMeanwhileFailsItsFrames) {
  const std::string bag = BagOf("Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb), "Image",
                                ImageMessage(kFirst_ns, "16UC1", 2, 1, 4, kUnits));
  const testing::TemporaryFolder folder;
  const std::string path = folder.Write("b.mcap", bag);
  const Bag open = OpenBag(path, {});
  EXPECT_EQ(Color(open.list.frames.at(0)).cols, 2);
  std::filesystem::resize_file(path, 0);
  EXPECT_THROW(open.list.frames.at(0).read_color(), std::invalid_argument);
}

// Between two records, or where a disk has zeros for what was written last.
TEST(DamagedBag, ThatHasNoEndIsNoted) {
  const std::string bag = BagOf("Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb), "Image",
                                ImageMessage(kFirst_ns, "16UC1", 2, 1, 4, kUnits));
  constexpr std::size_t kEnd = (9 + 4) + (9 + 20) + 8;  // DataEnd, Footer, and what ends a file
  const std::string cut = bag.substr(0, bag.size() - kEnd), at = std::to_string(cut.size());
  EXPECT_THAT(Read(bag).list.notes, ::testing::IsEmpty());
  EXPECT_THAT(Read(cut).list.notes, ElementsAre(HasSubstr("at byte " + at + " of " + at)));
  EXPECT_THAT(Read(cut + std::string(90, '\0')).list.notes,
              ElementsAre(HasSubstr("at byte " + at + " of ")));
}

// One byte of a chunk in the middle, compressed, or plain with and without a checksum.
TEST(DamagedBag, OfDamagedChunksTheOthersAreRead) {
  const auto bag_of = [](const char* compression, bool with_checksum) {
    BagWriter writer;
    for (int i = 0; i < 3; ++i) {
      const std::int64_t time_ns = kFirst_ns + i * 100 * kMillisecond_ns;
      writer.Add("/rgb", "Image", ImageMessage(time_ns, "rgb8", 2, 1, 6, kRgb));
      writer.Add("/depth", "Image", ImageMessage(time_ns, "16UC1", 2, 1, 4, kUnits));
      writer.EndChunk(compression, with_checksum);
    }
    return writer.Finish();
  };
  const auto damaged = [](std::string bag, std::size_t at) {
    bag[at] ^= 1;
    return Read(bag);
  };
  const std::string plain = bag_of("", false), checked = bag_of("", true);
  const std::size_t second = plain.find(kUnits, plain.find(kUnits) + 1);
  EXPECT_THAT(damaged(plain, second).list.notes, ::testing::IsEmpty()) << "nobody can know";

  const Bag bag = damaged(checked, second);
  ASSERT_EQ(bag.list.frames.size(), 2U);
  EXPECT_EQ(bag.list.frames[1].id, "1700000000.450000000");
  EXPECT_EQ(Depth(bag.list.frames[1]).at<std::uint16_t>(0, 1), 2500);
  const std::size_t at = 33 + (plain.size() - 33 - (9 + 4) - (9 + 20) - 8) / 3;
  EXPECT_THAT(bag.list.notes,
              ElementsAre("b.mcap has damaged records: 1, the first at byte " + std::to_string(at) +
                          ": a chunk is damaged: its checksum is another; what else it has is "
                          "read"));
  const std::string packed = bag_of("zstd", false);
  const std::size_t name = packed.find("zstd", packed.find("zstd") + 1);
  EXPECT_EQ(damaged(packed, name + 4 + 8).list.frames.size(), 2U) << "of the magic number";
}

// As where the chunk that says which topics there are is damaged.
TEST(DamagedBag, MessagesOfNoChannelAreLeftOut) {
  BagWriter writer;
  writer.Add("/rgb", "Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb));
  writer.Add("/depth", "Image", ImageMessage(kFirst_ns, "16UC1", 2, 1, 4, kUnits));
  writer.Add("/chatter", "String", "anything");
  writer.EndChunk("");
  std::string bag = writer.Finish();
  const std::string chatter = "/chatter", channel("\3\0\3\0\x08\0\0\0", 8);
  bag[bag.find(channel + chatter)] = '\7';
  EXPECT_EQ(Read(bag).list.frames.size(), 1U);
  EXPECT_THAT(Read(bag).list.notes,
              ElementsAre(HasSubstr("at byte 33: a message is of no channel")));
}

TEST(DamagedBag, BrokenImagesAreLeftOut) {
  BagWriter writer;
  const std::string color = ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb);
  for (const std::string& message : {color, color.substr(0, 20), std::string("cut")}) {
    writer.Add("/rgb", "Image", message);
  }
  writer.Add("/depth", "Image", ImageMessage(kFirst_ns, "16UC1", 2, 1, 4, kUnits));
  const Bag bag = Read(writer.Finish());
  EXPECT_EQ(bag.list.frames.size(), 1U);
  EXPECT_THAT(bag.list.notes, ElementsAre("broken images are left out: 2, the first is image 2 of "
                                          "/rgb: it ends too early"));
}

TEST(DamagedBag, BrokenImagesOfOtherTopicsDoNotMatter) {
  BagWriter writer;
  writer.Add("/infra1/image", "Image", "cut");
  writer.Add("/rgb", "Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb));
  writer.Add("/depth", "Image", ImageMessage(kFirst_ns, "16UC1", 2, 1, 4, kUnits));
  const std::string bag = writer.Finish();
  EXPECT_EQ(WhyNot(bag), "");
  EXPECT_EQ(WhyNot(bag, {.color_topic = "/infra1/image"}),
            "it has no frames; 1 depth images without colour within 20 ms; broken images are left "
            "out: 1, the first is image 1 of /infra1/image: a message is not in little-endian CDR");
}

// A chunk that says that it is larger than it is, or than is allowed.
TEST(DamagedBag, BelievesNoSizes) {
  BagWriter writer;
  writer.Add("/rgb", "Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb));
  writer.EndChunk("zstd");
  const std::string bytes = writer.Finish();
  const std::size_t size_at = bytes.find("zstd") - 16;
  std::string larger = bytes;
  larger[size_at + 3] = '\x0F';  // 240 MB
  EXPECT_EQ(WhyNot(larger),
            "it has no images of ROS 2; b.mcap has damaged records: 1, the first at byte 33: a "
            "chunk holds less than it says");
  larger[size_at + 5] = '\1';
  EXPECT_THAT(WhyNot(larger), HasSubstr("larger than 256 MiB"));
}

// Of a few bytes of a file, which hold as much as a chunk may, thousands of times.
TEST(DamagedBag, KeepsNoTextsOfAnySize) {
  const std::string color = ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb);
  const std::string depth = ImageMessage(kFirst_ns, "16UC1", 2, 1, 4, kUnits);
  BagWriter writer;
  writer.Add("/camera_info", "CameraInfo",
             testing::CameraInfoMessage(2, 1, 525) + std::string(1 << 20, 'x'));
  writer.Add("/" + std::string(300, 'a'), "Image", color);
  writer.Add("/rgb", "Image",
             ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb, std::string(1 << 20, 'f')));
  writer.Add("/depth", "Image", depth);
  const Bag bag = Read(writer.Finish());
  EXPECT_EQ(bag.list.frames.size(), 1U);
  EXPECT_EQ(ColorCameraOf(bag)->fx, 525);
  EXPECT_LE(bag.camera_info.size(), 1U << 16);
  EXPECT_LE(bag.color_frame.size(), 256U);
  EXPECT_THAT(bag.list.notes, ElementsAre(HasSubstr("b.mcap has damaged records: 2, the first ")));
}

TEST(DamagedBag, HasNoMoreImagesThanAreKept) {
  BagWriter writer;
  for (int i = 0; i < 3; ++i) {
    writer.Add("/rgb", "Image", ImageMessage(kFirst_ns + i, "rgb8", 2, 1, 6, kRgb));
  }
  writer.Add("/depth", "Image", ImageMessage(kFirst_ns, "16UC1", 2, 1, 4, kUnits));
  const std::string bag = writer.Finish();
  EXPECT_EQ(Read(bag, {.most_images = 4}).list.frames.size(), 1U);
  try {
    Read(bag, {.most_images = 3});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("it has more than 3 images"));
  }
}

}  // namespace
}  // namespace fovea::cli::small_bags
