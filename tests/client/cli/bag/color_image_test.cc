// The encodings of colour that drivers of cameras publish.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "tests/client/cli/bag/small_bags.h"
#include "tests/support/bag_writer.h"

namespace fovea::cli::small_bags {
namespace {

using ::testing::HasSubstr;
using testing::ImageMessage;

std::string BagOfColor(const std::string& encoding, std::uint32_t width, std::uint32_t height,
                       std::uint32_t step, const std::string& data) {
  return BagOf("Image", ImageMessage(kFirst_ns, encoding, width, height, step, data), "Image",
               ImageMessage(kFirst_ns, "16UC1", 2, 1, 4, kUnits));
}

cv::Mat ColorOf(const std::string& encoding, std::uint32_t width, std::uint32_t height,
                std::uint32_t step, const std::string& data) {
  const std::string bag = BagOfColor(encoding, width, height, step, data);
  return Color(Read(bag).list.frames.at(0));
}

// Of one colour, in 6 by 6 pixels whose first two rows begin with `pattern`: its red, green and
// blue are 200, 100 and 50.
cv::Mat FromBayer(const std::string& pattern) {
  std::string data;
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 6; ++x) {
      const char letter = pattern[static_cast<std::size_t>(y % 2 * 2 + x % 2)];
      data += static_cast<char>(letter == 'r' ? 200 : letter == 'g' ? 100 : 50);
    }
    data += "--";  // behind each row
  }
  return ColorOf("bayer_" + pattern + "8", 6, 6, 8, data);
}

TEST(ColorImage, BayerPatternsAreNamedByTheirFirstTwoRows) {
  for (const char* pattern : {"rggb", "bggr", "gbrg", "grbg"}) {
    const cv::Mat color = FromBayer(pattern);
    ASSERT_EQ(color.size(), cv::Size(6, 6)) << pattern;
    for (int y = 0; y < 6; ++y) {
      for (int x = 0; x < 6; ++x) {
        EXPECT_EQ(color.at<cv::Vec3b>(y, x), cv::Vec3b(50, 100, 200)) << pattern << x << "," << y;
      }
    }
  }
}

// Two pixels share a colour: red and its neighbour, darker. Y of 16 is black, U and V of 128 grey.
TEST(ColorImage, PixelsOfTwoBytesAreRead) {
  const std::string y0{"\x51"}, y1{"\x20"}, u{"\x5A"}, v{"\xF0"};
  for (const char* name : {"yuv422", "uyvy"}) {
    const cv::Mat color = ColorOf(name, 2, 1, 6, u + y0 + v + y1 + "--");
    EXPECT_LE(cv::norm(color.at<cv::Vec3b>(0, 0), cv::Vec3b(0, 0, 255), cv::NORM_INF), 2) << name;
    EXPECT_GT(color.at<cv::Vec3b>(0, 1)[2], 150) << name;
    EXPECT_LT(color.at<cv::Vec3b>(0, 1)[2], 220) << name;
  }
  for (const char* name : {"yuv422_yuy2", "yuyv"}) {
    const cv::Mat color = ColorOf(name, 2, 1, 4, y0 + u + y1 + v);
    EXPECT_LE(cv::norm(color.at<cv::Vec3b>(0, 0), cv::Vec3b(0, 0, 255), cv::NORM_INF), 2) << name;
    EXPECT_EQ(color.at<cv::Vec3b>(0, 1)[0], 0) << name;
  }
}

TEST(ColorImage, ChannelsAreInTheirOrderAndGreyIsGrey) {
  const std::string pixels("\1\2\3\xFF\4\5\6\xFF", 8);
  EXPECT_EQ(ColorOf("bgra8", 2, 1, 8, pixels).at<cv::Vec3b>(0, 1), cv::Vec3b(4, 5, 6));
  EXPECT_EQ(ColorOf("rgba8", 2, 1, 8, pixels).at<cv::Vec3b>(0, 1), cv::Vec3b(6, 5, 4));
  EXPECT_EQ(ColorOf("mono8", 2, 1, 2, pixels).at<cv::Vec3b>(0, 1), cv::Vec3b(2, 2, 2));
}

TEST(ColorImage, WithoutAWholePatternIsRefused) {
  const auto why_not = [](const std::string& encoding, std::uint32_t width, std::uint32_t height) {
    return WhyNot(BagOfColor(encoding, width, height, 2 * width, std::string(100, 'x')));
  };
  EXPECT_THAT(why_not("uyvy", 3, 1), HasSubstr("an image of uyvy has an odd width"));
  EXPECT_THAT(why_not("yuv422_yuy2", 1, 1), HasSubstr("yuv422_yuy2 has an odd width"));
  EXPECT_THAT(why_not("bayer_rggb8", 2, 4), HasSubstr("bayer_rggb8 has fewer than 3x3 pixels"));
  EXPECT_THAT(why_not("bayer_grbg8", 4, 2), HasSubstr("bayer_grbg8 has fewer than 3x3 pixels"));
  EXPECT_EQ(why_not("bayer_grbg8", 3, 3), "");
  EXPECT_THAT(why_not("yuyv", 30, 2), HasSubstr("fewer bytes"));
}

TEST(ColorImage, OfSixteenBitsIsRefusedByName) {
  for (const std::string encoding : {"rgb16", "bgr16", "mono16", "bayer_rggb16", "nv12"}) {
    EXPECT_THAT(WhyNot(BagOfColor(encoding, 2, 1, 12, std::string(12, 'x'))),
                HasSubstr("an image of encoding \"" + encoding +
                          "\" is no colour that is read (rgb8, bgr8, "));
  }
}

}  // namespace
}  // namespace fovea::cli::small_bags
