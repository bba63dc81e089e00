#include "client/image_files/image_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <vector>

#include "tests/server/frames.h"

namespace fovea::image_files {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

std::string ByOpenCv(const char* ending, const cv::Mat& image) {
  std::vector<unsigned char> bytes;
  cv::imencode(ending, image, bytes);
  return {bytes.begin(), bytes.end()};
}

cv::Mat ReadByOpenCv(const std::string& file) {
  return cv::imdecode(std::vector<char>(file.begin(), file.end()), cv::IMREAD_UNCHANGED);
}

double Difference(const cv::Mat& a, const cv::Mat& b) {
  return a.type() == b.type() ? cv::norm(a, b, cv::NORM_INF) : 1e9;
}

cv::Mat Ramp(int type) {
  cv::Mat image(33, 47, type);
  cv::randu(image, 0, image.depth() == CV_16U ? 65536 : 256);
  return image;
}

TEST(ImageFiles, OthersReadWhatIsWritten) {
  for (const int type : {CV_8UC1, CV_8UC3, CV_8UC4, CV_16UC1, CV_16UC3}) {
    const cv::Mat image = Ramp(type);
    EXPECT_EQ(Difference(ReadByOpenCv(EncodePng(image)), image), 0) << type;
    const cv::Mat part = image(cv::Rect(3, 5, 20, 11));
    EXPECT_EQ(Difference(ReadByOpenCv(EncodePng(part)), part), 0) << type;
  }
  const cv::Mat even(40, 50, CV_8UC3, cv::Scalar(200, 30, 10));
  EXPECT_LT(Difference(ReadByOpenCv(EncodeJpeg(even, 92)), even), 6);
  const cv::Mat gray(40, 50, CV_8UC1, cv::Scalar(77));
  EXPECT_LT(Difference(ReadByOpenCv(EncodeJpeg(gray, 92)), gray), 3);
}

TEST(ImageFiles, ReadWhatOthersWrote) {
  const cv::Mat color = Ramp(CV_8UC3), depth = Ramp(CV_16UC1);
  EXPECT_EQ(Difference(DecodeColor(ByOpenCv(".png", color)), color), 0);
  EXPECT_EQ(Difference(DecodeDepth(ByOpenCv(".png", depth)), depth), 0);
  const std::string jpeg = ByOpenCv(".jpg", color);
  EXPECT_LT(Difference(DecodeColor(jpeg), ReadByOpenCv(jpeg)), 4);
}

TEST(ImageFiles, ColorIsOfThreeChannelsWhateverItWas) {
  const cv::Mat blue(4, 5, CV_8UC4, cv::Scalar(255, 1, 2, 7));
  EXPECT_EQ(Difference(DecodeColor(EncodePng(blue)), cv::Mat(4, 5, CV_8UC3, cv::Scalar(255, 1, 2))),
            0);
  const cv::Mat gray(4, 5, CV_8UC1, cv::Scalar(77));
  const cv::Mat in_three(4, 5, CV_8UC3, cv::Scalar::all(77));
  EXPECT_EQ(Difference(DecodeColor(EncodePng(gray)), in_three), 0);
  EXPECT_LT(Difference(DecodeColor(EncodeJpeg(gray, 92)), in_three), 3);
  const cv::Mat deep(4, 5, CV_16UC3, cv::Scalar(65535, 0, 257));
  EXPECT_EQ(Difference(DecodeColor(EncodePng(deep)), cv::Mat(4, 5, CV_8UC3, cv::Scalar(255, 0, 1))),
            0);
}

TEST(ImageFiles, SayWhatIsWrong) {
  const auto says = [](const char* text) {
    return ThrowsMessage<std::runtime_error>(HasSubstr(text));
  };
  const std::string png = EncodePng(Ramp(CV_8UC3)), depth = EncodePng(Ramp(CV_16UC1));
  const std::string jpeg = EncodeJpeg(Ramp(CV_8UC3), 92);
  EXPECT_THAT([&] { DecodeColor(png.substr(0, png.size() / 2)); }, says("not a whole PNG"));
  EXPECT_THAT([&] { DecodeDepth(depth.substr(0, depth.size() / 2)); }, says("not a whole PNG"));
  EXPECT_THAT([&] { DecodeColor(jpeg.substr(0, jpeg.size() / 2)); }, says("nor a whole JPEG"));
  EXPECT_THAT([] { DecodeColor("text"); }, says("neither a PNG"));
  EXPECT_THAT([] { DecodeColor(""); }, says("neither a PNG"));
  EXPECT_THAT([&] { DecodeDepth(png); }, says("not one channel of 16 bits"));
  EXPECT_THAT([&] { DecodeDepth(jpeg); }, says("not a PNG"));
  EXPECT_THAT([] { EncodeJpeg(cv::Mat(1, 70000, CV_8UC1, cv::Scalar(0)), 92); },
              says("no JPEG of it"));
}

TEST(ImageFiles, TakeNoMemoryForWhatIsOnlyClaimed) {
  const auto is_too_large = ThrowsMessage<std::runtime_error>(HasSubstr("too large to be read"));
  EXPECT_THAT([] { DecodeColor(testing::PngClaiming(65535, 65535)); }, is_too_large);
  EXPECT_THAT([] { DecodeColor(testing::JpegClaiming(65000, 65000)); }, is_too_large);
}

}  // namespace
}  // namespace fovea::image_files
