// Bags of many chunks, and of many messages in one.
#include <gtest/gtest.h>

#include <atomic>

#include "client/cli/bag/decompression.h"
#include "client/cli/bag/growing_bytes.h"
#include "tests/client/cli/bag/small_bags.h"
#include "tests/support/bag_writer.h"

namespace fovea::cli::small_bags {
namespace {

using testing::BagWriter;
using testing::ImageMessage;

// Memory for what they say that they hold took longer than all else.
TEST(ManyChunks, GrowWithWhatTheyHold) {
  GrowingBytes bytes;
  bytes.Clear(256U << 20);
  EXPECT_LE(bytes.Room(), 1U << 16);
  EXPECT_EQ(bytes.Content(), "");
}

// New memory for each did, too.
TEST(ManyChunks, AreDecompressedIntoTheSameMemory) {
  Decompressor decompressor;
  const std::string packed("\x28\xB5\x2F\xFD\x20\x02\x11\x00\x00hi", 11);
  const std::string_view first = decompressor.Chunk(packed, "zstd", 2);
  EXPECT_EQ(first, "hi");
  EXPECT_EQ(decompressor.Chunk(packed, "zstd", 2).data(), first.data());
}

// As where a bag was written with chunks of hundreds of megabytes.
TEST(ManyChunks, WithManyMessagesAreReadOnceForAll) {
  constexpr int kNumber = 10;
  BagWriter writer;
  for (int i = 0; i < kNumber; ++i) {
    const std::int64_t time_ns = kFirst_ns + i * 100 * kMillisecond_ns;
    writer.Add("/rgb", "Image", ImageMessage(time_ns, "rgb8", 2, 1, 6, kRgb));
    writer.Add("/depth", "Image", ImageMessage(time_ns, "16UC1", 2, 1, 4, kUnits));
  }
  writer.EndChunk("zstd");
  const std::string bytes = writer.Finish();
  const McapBytes memory = McapInMemory(bytes);
  std::atomic<int> num_reads = 0;
  const McapBytes counted{memory.size, [&](std::uint64_t start, std::uint64_t size) {
                            ++num_reads;
                            return memory.part(start, size);
                          }};
  const Bag bag = ReadBag({{"b.mcap", McapFile(counted)}}, {});
  num_reads = 0;
  ASSERT_EQ(bag.list.frames.size(), 10U);
  for (const FrameFiles& frame : bag.list.frames) {
    EXPECT_EQ(Color(frame).at<cv::Vec3b>(0, 0), cv::Vec3b(0, 0, 255));
    EXPECT_EQ(Depth(frame).at<std::uint16_t>(0, 1), 2500);
  }
  EXPECT_EQ(num_reads, 1);
}

}  // namespace
}  // namespace fovea::cli::small_bags
