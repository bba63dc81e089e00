// Bags of `ros2 bag record --compression-mode message --compression-format zstd`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zstd.h>

#include <opencv2/core.hpp>

#include "client/cli/bag/decompression.h"
#include "tests/client/cli/bag/small_bags.h"
#include "tests/support/bag_writer.h"

namespace fovea::cli::small_bags {
namespace {

using testing::CameraInfoMessage;
using ::testing::HasSubstr;
using testing::ImageMessage;

std::string Packed(const std::string& message) {
  std::string packed(ZSTD_compressBound(message.size()), '\0');
  packed.resize(
      ZSTD_compress(packed.data(), packed.size(), message.data(), message.size(), /*level=*/1));
  return packed;
}

const std::string kColorMessage = ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb),
                  kDepthMessage = ImageMessage(kFirst_ns, "16UC1", 2, 1, 4, kUnits);

TEST(MessageCompression, OfAllMessagesIsRead) {
  testing::BagWriter writer;
  writer.Add("/camera_info", "CameraInfo", Packed(CameraInfoMessage(2, 1, 525, -0.25)));
  writer.Add("/rgb", "Image", Packed(kColorMessage));
  writer.Add("/depth", "Image", Packed(kDepthMessage));
  const std::string bytes = writer.Finish();
  const Bag bag = Read(bytes);
  EXPECT_THAT(bag.list.notes, ::testing::IsEmpty());
  ASSERT_EQ(bag.list.frames.size(), 1U);
  EXPECT_EQ(bag.list.frames[0].id, "1700000000.250000000");
  EXPECT_EQ(bag.color_frame, "camera");
  EXPECT_EQ(Color(bag.list.frames[0]).at<cv::Vec3b>(0, 0), cv::Vec3b(0, 0, 255));
  EXPECT_EQ(Depth(bag.list.frames[0]).at<std::uint16_t>(0, 1), 2500);
  ASSERT_TRUE(ColorCameraOf(bag));
  EXPECT_EQ(ColorCameraOf(bag)->fx, 525);
}

// Of which only the beginning is unpacked to see what it is.
TEST(MessageCompression, OfImagesThatAreLargerThanTheirHeadIsRead) {
  const std::string color =
      ImageMessage(kFirst_ns, "rgb8", 400, 300, 1200, std::string(360000, 'c'));
  const std::string bytes = BagOf("Image", Packed(color), "Image", Packed(kDepthMessage));
  const Bag bag = Read(bytes);
  ASSERT_EQ(bag.list.frames.size(), 1U);
  EXPECT_EQ(Color(bag.list.frames[0]).size(), cv::Size(400, 300));
}

TEST(MessageCompression, OfDamagedMessagesSaysSo) {
  const std::string packed = Packed(kColorMessage);
  EXPECT_THAT(WhyNot(BagOf("Image", packed.substr(0, packed.size() - 3), "Image", kDepthMessage)),
              HasSubstr("image 1 of /rgb: zstd: it ends too early"));
  std::string other = packed;
  other[4] = '\xFF';
  EXPECT_THAT(WhyNot(BagOf("Image", other, "Image", kDepthMessage)),
              HasSubstr("image 1 of /rgb: zstd: "));
}

// The head of a frame that says that it holds 2^40 bytes.
TEST(MessageCompression, BelievesNoSizes) {
  const std::string frame("\x28\xB5\x2F\xFD\xE0\0\0\0\0\0\1\0\0", 13);
  EXPECT_THAT(WhyNot(BagOf("Image", frame, "Image", kDepthMessage)),
              HasSubstr("image 1 of /rgb: zstd: "));
  EXPECT_THROW(Unpacked(frame), std::invalid_argument);
}

}  // namespace
}  // namespace fovea::cli::small_bags
