// Bags with more damaged records than anybody wrote.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/client/cli/bag/small_bags.h"
#include "tests/support/bag_writer.h"

namespace fovea::cli::small_bags {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::ImageMessage;

constexpr int kManyRecords = 150'000;

template <typename Value>
std::string LittleEndian(Value value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string McapRecord(std::uint8_t kind, const std::string& content) {
  return LittleEndian(kind) + LittleEndian(std::uint64_t{content.size()}) + content;
}

// A chunk of that record, many times, and then a frame.
std::string BehindMany(const std::string& record) {
  std::string records;
  for (int i = 0; i < kManyRecords; ++i) records += record;
  const std::string zero = LittleEndian(std::uint64_t{0}),
                    size = LittleEndian(std::uint64_t{records.size()});
  const std::string chunk = zero + zero + size + std::string(8, '\0') + size + records;
  std::string bag = BagOf("Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb), "Image",
                          ImageMessage(kFirst_ns, "16UC1", 2, 1, 4, kUnits));
  constexpr std::size_t kMagic = 8;
  return bag.insert(kMagic, McapRecord(6, chunk));
}

// As of a sensor with a thousand a second, where the chunk that names its topic is damaged.
TEST(ManyDamages, MessagesOfNoChannelAreNoReasonToStop) {
  const std::string bytes = BehindMany(McapRecord(5, std::string(22, '\0')));
  const Bag bag = Read(bytes);
  EXPECT_EQ(bag.list.frames.size(), 1U);
  EXPECT_THAT(bag.list.notes, ElementsAre(HasSubstr(
                                  "has damaged records: 150000, the first at byte 8: a message is "
                                  "of no channel")));
}

// Of a few kilobytes, once compressed, that took minutes.
TEST(ManyDamages, RecordsThatAreNoneAreAReasonToStop) {
  EXPECT_THAT(WhyNot(BehindMany(McapRecord(5, ""))),
              HasSubstr("the first at byte 8: it ends too early; b.mcap breaks off at byte 8 of "));
}

}  // namespace
}  // namespace fovea::cli::small_bags
