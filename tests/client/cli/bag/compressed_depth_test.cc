// Depth as compressed_depth_image_transport writes it: 12 bytes of parameters before PNG or RVL.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <opencv2/core.hpp>

#include "client/image_files/image_files.h"
#include "client/rvl.h"
#include "tests/client/cli/bag/small_bags.h"
#include "tests/support/bag_writer.h"

namespace fovea::cli::small_bags {
namespace {

using testing::CompressedMessage;
using ::testing::HasSubstr;
using testing::ImageMessage;

template <typename Value>
std::string Bytes(Value value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string Parameters(float a, float b) { return Bytes(std::int32_t{1}) + Bytes(a) + Bytes(b); }

std::string Rvl(std::uint32_t width, std::uint32_t height,
                const std::vector<std::uint16_t>& values) {
  return Bytes(width) + Bytes(height) + client::EncodeRvl(values.data(), values.size());
}

std::string BagOfDepth(const std::string& format, const std::string& file) {
  return BagOf("Image", ImageMessage(kFirst_ns, "rgb8", 2, 1, 6, kRgb), "CompressedImage",
               CompressedMessage(kFirst_ns, format, file));
}

cv::Mat DepthOf(const std::string& format, const std::string& file) {
  const std::string bag = BagOfDepth(format, file);
  return Depth(Read(bag).list.frames.at(0));
}

TEST(CompressedDepth, OfMillimetresInRvlIsRead) {
  const std::vector<std::uint16_t> values{0, 0, 1000, 1004, 65535, 0};
  for (const char* format : {"16UC1; compressedDepth rvl", "mono16; compressedDepth rvl"}) {
    const cv::Mat depth = DepthOf(format, Parameters(0, 0) + Rvl(3, 2, values));
    ASSERT_EQ(depth.size(), cv::Size(3, 2)) << format;
    EXPECT_TRUE(std::equal(values.begin(), values.end(), depth.begin<std::uint16_t>()));
  }
}

// The codes of 0, 0, 1, 3 without the project's own encoder: runs of two and two, steps of 1 and 2.
TEST(CompressedDepth, InRvlIsReadByTheFormThatWasPublished) {
  const cv::Mat depth =
      DepthOf("16UC1; compressedDepth rvl",
              Parameters(0, 0) + Bytes(4U) + Bytes(1U) + Bytes(std::uint32_t{0x22240000}));
  ASSERT_EQ(depth.size(), cv::Size(4, 1));
  EXPECT_EQ(depth.at<std::uint16_t>(0, 1), 0);
  EXPECT_EQ(depth.at<std::uint16_t>(0, 2), 1);
  EXPECT_EQ(depth.at<std::uint16_t>(0, 3), 3);
}

// A / depth + B.
TEST(CompressedDepth, OfMetresIsReadFromItsInverse) {
  const float a = 100.F * 101.F, b = 1 - a / 10;
  const auto inverse = static_cast<std::uint16_t>(a / 2 + b);
  const cv::Mat image = (cv::Mat_<std::uint16_t>(1, 2) << inverse, 0);
  const std::string png = Parameters(a, b) + image_files::EncodePng(image);
  const std::string rvl = Parameters(a, b) + Rvl(2, 1, {inverse, 0});
  for (const auto& [format, file] :
       {std::pair("32FC1; compressedDepth png", png), std::pair("32FC1; compressedDepth", png),
        std::pair("32FC1; compressedDepth rvl", rvl)}) {
    const cv::Mat depth = DepthOf(format, file);
    EXPECT_NEAR(depth.at<std::uint16_t>(0, 0), 2000, 1) << format;
    EXPECT_EQ(depth.at<std::uint16_t>(0, 1), 0) << format;
  }
  EXPECT_NE(WhyNot(BagOfDepth("32FC1; compressedDepth png", png.substr(0, 40))), "");
}

TEST(CompressedDepth, InRvlThatIsDamagedSaysSo) {
  const std::string rvl = Rvl(2, 1, {1000, 2500}), parameters = Parameters(0, 0);
  for (const std::string encoding : {"16UC1", "32FC1"}) {
    const auto why_not = [&](const std::string& file) {
      return WhyNot(BagOfDepth(encoding + "; compressedDepth rvl", file));
    };
    EXPECT_EQ(why_not(parameters + rvl), "");
    for (const std::size_t size : {0, 1, 12, 19}) {
      EXPECT_THAT(why_not((parameters + rvl).substr(0, size)), HasSubstr("it ends too early"));
    }
    EXPECT_THAT(why_not(parameters + rvl.substr(0, 8)), HasSubstr("RVL is damaged"));
    EXPECT_THAT(why_not(parameters + Bytes(3U) + rvl.substr(4)),
                HasSubstr("an image in RVL is damaged: it is not of 3x1 pixels"));
    EXPECT_THAT(why_not(parameters + Bytes(0U) + rvl.substr(4)), HasSubstr("has no pixels"));
    // The codes of which are three words.
    EXPECT_THAT(why_not(parameters + Bytes(1U << 20) + Bytes(1U << 20) + rvl.substr(8)),
                HasSubstr("too large to be read"));
  }
}

TEST(CompressedDepth, OfOtherFormatsIsNamed) {
  for (const char* format :
       {"16UC1; compressedDepth zip", "8UC1; compressedDepth rvl", "32FC1; compressedDepth png"}) {
    EXPECT_THAT(WhyNot(BagOfDepth(format, "0123456789abcdefghij")),
                HasSubstr(std::string("encoding \"") + format + "\" is no depth that is read"));
  }
}

}  // namespace
}  // namespace fovea::cli::small_bags
