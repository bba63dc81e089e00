// The decoders against hostile bytes: whole files come back exactly, anything else is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <opencv2/core.hpp>
#include <random>
#include <stdexcept>

#include "client/rvl.h"
#include "server/codec/jpeg.h"
#include "server/codec/png.h"
#include "server/codec/raw.h"
#include "server/codec/rvl.h"
#include "server/codec/zstd.h"
#include "tests/server/frames.h"

namespace fovea::server {
namespace {

using testing::BytesOf;
using ::testing::HasSubstr;
using testing::JpegClaiming;
using testing::JpegOf;
using testing::kDepthBytes;
using testing::PngClaiming;
using testing::PngOf;
using testing::RvlOf;
using testing::TestColor;
using testing::TestDepth;
using ::testing::ThrowsMessage;
using testing::ZstdOf;

const SizeLimits kLimits{.max_pixels = 10'000};

double Difference(const cv::Mat& a, const cv::Mat& b) { return cv::norm(a, b, cv::NORM_INF); }

// There must be no length at which a cut file passes. `spare` bytes at its end carry nothing.
void ExpectEveryPrefixRefused(const std::string& file,
                              const std::function<void(std::string_view)>& decode,
                              std::size_t spare = 0) {
  for (std::size_t size = 0; size < file.size() - spare; ++size) {
    EXPECT_THROW(decode(std::string_view(file).substr(0, size)), std::invalid_argument)
        << size << " of " << file.size() << " bytes";
  }
}

TEST(Jpeg, DecodesToRgb) {
  const cv::Mat image = DecodeJpeg(JpegOf(TestColor()), kLimits);
  ASSERT_EQ(image.type(), CV_8UC3);
  EXPECT_LE(Difference(image, TestColor()), 12);
}

TEST(Jpeg, RefusesTruncatedFiles) {
  ExpectEveryPrefixRefused(JpegOf(TestColor()),
                           [](std::string_view file) { DecodeJpeg(file, kLimits); });
}

TEST(Jpeg, ChecksTheClaimedSizeFirst) {
  EXPECT_THAT([] { DecodeJpeg(JpegClaiming(65500, 65500), kLimits); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("65500x65500")));
}

// A grey block: of the scans after the first, each says of one coefficient that it is 0, by a bit.
std::string JpegOfScans(int num_scans) {
  const std::string one_code("\x01" + std::string(15, '\0') + '\0');  // of one bit, for 0
  std::string file = "\xFF\xD8" + ("\xFF\xDB" + std::string("\0\x43\0", 3)) + std::string(64, '\1');
  file += "\xFF\xC2" + std::string("\0\x0B\x08\0\x08\0\x08\x01\x01\x11\0", 11);
  for (const char table : {'\x00', '\x10'}) {
    file += "\xFF\xC4" + std::string("\0\x14", 2) + table + one_code;
  }
  for (int scan = 0; scan < num_scans; ++scan) {
    const int place = scan == 0 ? 0 : (scan - 1) % 63 + 1, pass = (scan - 1) / 63;
    const int bits = pass == 0 ? (scan == 0 ? 0 : 3) : (4 - pass) << 4 | (3 - pass);
    file += "\xFF\xDA" + std::string("\0\x08\x01\x01\0", 5);
    for (const int byte : {place, place, bits}) file += static_cast<char>(byte);
    file += '\x7F';
  }
  return file + "\xFF\xD9";
}

TEST(Jpeg, IsRefusedWhereItHasTooManyScans) {
  EXPECT_EQ(DecodeJpeg(JpegOfScans(64), kLimits).size(), cv::Size(8, 8));
  EXPECT_THAT([] { DecodeJpeg(JpegOfScans(65), kLimits); },
              ThrowsMessage<std::invalid_argument>("a JPEG of more than 64 scans"));
}

TEST(Png, DecodesColorExactly) {
  EXPECT_EQ(Difference(DecodePngColor(PngOf(TestColor()), kLimits), TestColor()), 0);
}

TEST(Png, DropsAlpha) {
  const cv::Mat blue_rgba(4, 5, CV_8UC4, cv::Scalar(255, 0, 0, 7));  // B first for PngOf
  const cv::Mat image = DecodePngColor(PngOf(blue_rgba), kLimits);
  EXPECT_EQ(Difference(image, cv::Mat(4, 5, CV_8UC3, cv::Scalar(0, 0, 255))), 0);
}

TEST(Png, SpreadsGrayOverThreeChannels) {
  const cv::Mat gray(4, 5, CV_8UC1, cv::Scalar(77));
  const cv::Mat image = DecodePngColor(PngOf(gray), kLimits);
  EXPECT_EQ(Difference(image, cv::Mat(4, 5, CV_8UC3, cv::Scalar::all(77))), 0);
}

TEST(Png, DecodesDepthExactly) {
  EXPECT_EQ(Difference(DecodePngGray16(PngOf(TestDepth()), kLimits), TestDepth()), 0);
}

TEST(Png, RefusesSixteenBitColor) {
  const cv::Mat deep(4, 5, CV_16UC3, cv::Scalar::all(1000));
  EXPECT_THAT([&] { DecodePngColor(PngOf(deep), kLimits); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("16 bits")));
}

TEST(Png, RefusesDepthThatIsNotOneChannelOfSixteenBits) {
  const cv::Mat gray(4, 5, CV_8UC1, cv::Scalar(77)), deep(4, 5, CV_16UC3, cv::Scalar::all(1));
  EXPECT_THROW(DecodePngGray16(PngOf(gray), kLimits), std::invalid_argument);
  EXPECT_THROW(DecodePngGray16(PngOf(deep), kLimits), std::invalid_argument);
}

TEST(Png, RefusesTruncatedFiles) {
  constexpr std::size_t kEndChecksum = 4;  // of an empty chunk
  ExpectEveryPrefixRefused(
      PngOf(TestColor()), [](std::string_view file) { DecodePngColor(file, kLimits); },
      kEndChecksum);
  ExpectEveryPrefixRefused(
      PngOf(TestDepth()), [](std::string_view file) { DecodePngGray16(file, kLimits); },
      kEndChecksum);
}

TEST(Png, ChecksTheClaimedSizeFirst) {
  EXPECT_THAT([] { DecodePngColor(PngClaiming(100'000, 100'000), kLimits); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("100000x100000")));
}

TEST(Zstd, DecompressesExactly) {
  const std::string bytes = BytesOf(TestDepth());
  EXPECT_EQ(DecompressZstd(ZstdOf(bytes), bytes.size()), bytes);
}

TEST(Zstd, RefusesTruncatedFrames) {
  const std::string bytes = BytesOf(TestDepth());
  ExpectEveryPrefixRefused(ZstdOf(bytes),
                           [&](std::string_view frame) { DecompressZstd(frame, bytes.size()); });
}

TEST(Zstd, RefusesAnotherSizeAndWhatFollows) {
  const std::string bytes = BytesOf(TestDepth()), frame = ZstdOf(bytes);
  EXPECT_THROW(DecompressZstd(frame, bytes.size() - 1), std::invalid_argument);
  EXPECT_THROW(DecompressZstd(frame, bytes.size() + 1), std::invalid_argument);
  EXPECT_THROW(DecompressZstd(frame + "x", bytes.size()), std::invalid_argument);
  EXPECT_THROW(DecompressZstd(frame + frame, 2 * bytes.size()), std::invalid_argument);
}

TEST(Zstd, RefusesBombs) {
  const std::string bomb = ZstdOf(std::string(50'000'000, '\0'));
  ASSERT_LT(bomb.size(), 10'000U);
  EXPECT_THROW(DecompressZstd(bomb, kDepthBytes), std::invalid_argument);
}

TEST(Zstd, HoldsAtMostWhatIsWanted) {
  const std::string bytes = BytesOf(TestDepth()), frame = ZstdOf(bytes);
  EXPECT_EQ(DecompressZstdUpTo(frame, bytes.size()), bytes);
  EXPECT_EQ(DecompressZstdUpTo(frame, 2 * bytes.size()), bytes);
  EXPECT_THROW(DecompressZstdUpTo(frame, bytes.size() - 1), std::invalid_argument);
}

// Two pixels without depth, two with 5 and 4: 2, 2, 5 = 10 as two nibbles, -1 = 1.
TEST(Rvl, HasTheCodesOfThePaper) {
  const cv::Mat depth = (cv::Mat_<std::uint16_t>(1, 4) << 0, 0, 5, 4);
  const std::string codes("\x00\x10\xA1\x22", 4);
  EXPECT_EQ(RvlOf(depth), codes);
  EXPECT_EQ(Difference(DecodeRvl(codes, 4, 1), depth), 0);
}

TEST(Rvl, DecodesExactly) {
  cv::Mat extremes(24, 32, CV_16UC1, cv::Scalar(65535));
  extremes.forEach<std::uint16_t>([](std::uint16_t& value, const int* at) {
    if ((at[0] + at[1]) % 2 == 0) value = 1;
  });
  const cv::Mat nothing = cv::Mat::zeros(24, 32, CV_16UC1);
  for (const cv::Mat& depth : {TestDepth(), extremes, nothing}) {
    const std::string codes = RvlOf(depth);
    EXPECT_LE(codes.size(), MaxRvlBytes(depth.total()));
    EXPECT_EQ(client::MaxRvlBytes(depth.total()), MaxRvlBytes(depth.total()));
    EXPECT_EQ(Difference(DecodeRvl(codes, depth.cols, depth.rows), depth), 0);
  }
}

TEST(Rvl, RefusesTruncatedCodesAndWhatFollows) {
  const std::string codes = RvlOf(TestDepth());
  const auto decode = [](std::string_view bytes) { DecodeRvl(bytes, 32, 24); };
  ExpectEveryPrefixRefused(codes, decode);
  EXPECT_THROW(decode(codes + std::string(4, '\0')), std::invalid_argument);
}

TEST(Rvl, RefusesRunsAndValuesOutOfRange) {
  const std::string long_run("\x00\x00\x00\x50", 4);  // of 5 pixels
  EXPECT_THAT([&] { DecodeRvl(long_run, 4, 1); },
              ThrowsMessage<std::invalid_argument>("an RVL run of 5 pixels, 4 are left"));
  const std::string negative("\x00\x00\x10\x01", 4);  // a run of one that is -1
  EXPECT_THAT([&] { DecodeRvl(negative, 1, 1); },
              ThrowsMessage<std::invalid_argument>("an RVL depth of -1"));
  EXPECT_THROW(DecodeRvl(std::string(8, '\xFF'), 1, 1), std::invalid_argument);  // never ends
}

TEST(AnyDecoder, SurvivesRandomDamage) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const std::vector<std::pair<std::string, std::function<void(const std::string&)>>> decoders{
      {JpegOf(TestColor()), [](const std::string& file) { DecodeJpeg(file, kLimits); }},
      {PngOf(TestColor()), [](const std::string& file) { DecodePngColor(file, kLimits); }},
      {PngOf(TestDepth()), [](const std::string& file) { DecodePngGray16(file, kLimits); }},
      {ZstdOf(BytesOf(TestDepth())),
       [](const std::string& file) { DecompressZstd(file, kDepthBytes); }},
      {RvlOf(TestDepth()), [](const std::string& file) { DecodeRvl(file, 32, 24); }}};
  for (const auto& [file, decode] : decoders) {
    for (int i = 0; i < 500; ++i) {
      std::string damaged = file;
      for (int k = 0; k < 3; ++k) damaged[random() % damaged.size()] = static_cast<char>(random());
      try {
        decode(damaged);  // damage may be harmless
      } catch (const std::invalid_argument&) {
      }
    }
  }
}

TEST(Raw, RefusesAnotherNumberOfBytes) {
  EXPECT_THAT([] { ImageFromRows("0123456789", 640, 480, CV_16UC1, "16UC1"); },
              ThrowsMessage<std::invalid_argument>("has 10 bytes, 640x480 16UC1 needs 614400"));
}

TEST(Raw, TurnsSixteenBitUnitsToMeters) {
  const cv::Mat units = (cv::Mat_<std::uint16_t>(1, 3) << 0, 1, 65535);
  const cv::Mat meters = MetersFrom16U(units, 0.0001);
  EXPECT_TRUE(std::isnan(meters.at<float>(0)));
  EXPECT_FLOAT_EQ(meters.at<float>(1), 0.0001F);
  EXPECT_FLOAT_EQ(meters.at<float>(2), 6.5535F);
}

TEST(Raw, KeepsOnlyFinitePositiveFloats) {
  const cv::Mat values = (cv::Mat_<float>(1, 6) << 1.5F, 0, -1, NAN, INFINITY, -INFINITY);
  const cv::Mat meters = MetersFrom32F(values);
  EXPECT_EQ(meters.at<float>(0), 1.5F);
  for (int i = 1; i < 6; ++i) EXPECT_TRUE(std::isnan(meters.at<float>(i))) << i;
}

}  // namespace
}  // namespace fovea::server
