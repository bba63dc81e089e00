#include "tests/server/frames.h"

#include <zstd.h>

#include <limits>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "client/image_files/image_files.h"
#include "client/rvl.h"

namespace fovea::testing {
namespace {

cv::Mat ToBgr(const cv::Mat& image) {
  if (image.channels() != 3) return image;
  cv::Mat bgr;
  cv::cvtColor(image, bgr, cv::COLOR_RGB2BGR);
  return bgr;
}

void PutBigEndian32(std::uint32_t value, std::string* bytes, std::size_t at) {
  for (int i = 0; i < 4; ++i) (*bytes)[at + i] = static_cast<char>(value >> (24 - 8 * i));
}

std::uint32_t Crc(const std::string& bytes) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int i = 0; i < 8; ++i) crc = (crc >> 1) ^ (crc & 1 ? 0xEDB88320 : 0);
  }
  return ~crc;
}

template <typename Image, typename Encoding>
Image MessageOf(Encoding encoding, std::string bytes, int width, int height) {
  Image image;
  image.set_encoding(encoding);
  image.set_width(static_cast<std::uint32_t>(width));
  image.set_height(static_cast<std::uint32_t>(height));
  image.set_data(std::move(bytes));
  return image;
}

}  // namespace

cv::Mat TestColor() {
  cv::Mat image(kHeight, kWidth, CV_8UC3);
  image.forEach<cv::Vec3b>([](cv::Vec3b& pixel, const int* at) {
    pixel = cv::Vec3b(static_cast<std::uint8_t>(200 - at[0]), static_cast<std::uint8_t>(4 * at[1]),
                      static_cast<std::uint8_t>(2 * at[0] + at[1]));
  });
  return image;
}

cv::Mat TestDepth() {
  cv::Mat image(kHeight, kWidth, CV_16UC1);
  image.forEach<std::uint16_t>([](std::uint16_t& pixel, const int* at) {
    pixel = static_cast<std::uint16_t>(at[1] % 7 == 0 ? 0 : 800 + 300 * (at[0] % 2) + at[1]);
  });
  return image;
}

cv::Mat TestMeters() {
  const cv::Mat depth = TestDepth();
  cv::Mat meters(depth.size(), CV_32FC1);
  meters.forEach<float>([&](float& value, const int* at) {
    const int units = depth.at<std::uint16_t>(at[0], at[1]);
    value =
        units == 0 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(units * 0.001);
  });
  return meters;
}

std::string BytesOf(const cv::Mat& image) {
  return {reinterpret_cast<const char*>(image.data), image.total() * image.elemSize()};
}

std::string PngOf(const cv::Mat& image) { return image_files::EncodePng(ToBgr(image)); }

std::string JpegOf(const cv::Mat& image_rgb) {
  constexpr int kQuality = 95;
  return image_files::EncodeJpeg(ToBgr(image_rgb), kQuality);
}

std::string ZstdOf(const std::string& bytes) {
  std::string result(ZSTD_compressBound(bytes.size()), '\0');
  result.resize(ZSTD_compress(result.data(), result.size(), bytes.data(), bytes.size(), 1));
  return result;
}

std::string RvlOf(const cv::Mat& depth) {
  return client::EncodeRvl(depth.ptr<std::uint16_t>(), depth.total());
}

std::vector<v1::ColorImage> TestColors() {
  const cv::Mat color = TestColor();
  return {ColorMessage(v1::COLOR_ENCODING_RGB8, BytesOf(color), kWidth, kHeight),
          ColorMessage(v1::COLOR_ENCODING_BGR8, BytesOf(ToBgr(color)), kWidth, kHeight),
          ColorMessage(v1::COLOR_ENCODING_PNG, PngOf(color)),
          ColorMessage(v1::COLOR_ENCODING_JPEG, JpegOf(color), kWidth, kHeight)};
}

std::vector<v1::DepthImage> TestDepths() {
  const cv::Mat depth = TestDepth();
  const std::string units = BytesOf(depth), meters = BytesOf(TestMeters()), rvl = RvlOf(depth);
  const auto raw = [](v1::DepthEncoding encoding, const std::string& bytes) {
    return DepthMessage(encoding, bytes, kWidth, kHeight);
  };
  return {raw(v1::DEPTH_ENCODING_16UC1, units),
          raw(v1::DEPTH_ENCODING_32FC1, meters),
          DepthMessage(v1::DEPTH_ENCODING_16UC1_PNG, PngOf(depth)),
          raw(v1::DEPTH_ENCODING_16UC1_ZSTD, ZstdOf(units)),
          raw(v1::DEPTH_ENCODING_32FC1_ZSTD, ZstdOf(meters)),
          raw(v1::DEPTH_ENCODING_16UC1_RVL, rvl),
          raw(v1::DEPTH_ENCODING_16UC1_RVL_ZSTD, ZstdOf(rvl))};
}

v1::Frame TestFrame() {
  v1::Frame frame;
  frame.set_id("frame-7");
  *frame.mutable_color() =
      ColorMessage(v1::COLOR_ENCODING_RGB8, BytesOf(TestColor()), kWidth, kHeight);
  *frame.mutable_depth() =
      DepthMessage(v1::DEPTH_ENCODING_16UC1, BytesOf(TestDepth()), kWidth, kHeight);
  frame.mutable_intrinsics()->set_fx(30);
  frame.mutable_intrinsics()->set_fy(30);
  frame.mutable_intrinsics()->set_cx(15.5);
  frame.mutable_intrinsics()->set_cy(11.5);
  return frame;
}

v1::DetectRequest TestRequest() {
  v1::DetectRequest request;
  *request.mutable_frame() = TestFrame();
  return request;
}

v1::ColorImage ColorMessage(v1::ColorEncoding encoding, std::string bytes, int width, int height) {
  return MessageOf<v1::ColorImage>(encoding, std::move(bytes), width, height);
}

v1::DepthImage DepthMessage(v1::DepthEncoding encoding, std::string bytes, int width, int height) {
  return MessageOf<v1::DepthImage>(encoding, std::move(bytes), width, height);
}

std::string PngClaiming(std::uint32_t width, std::uint32_t height) {
  std::string file = PngOf(TestColor());
  constexpr std::size_t kType = 12, kSize = 16, kCrc = 29;  // of the IHDR chunk
  PutBigEndian32(width, &file, kSize);
  PutBigEndian32(height, &file, kSize + 4);
  PutBigEndian32(Crc(file.substr(kType, kCrc - kType)), &file, kCrc);
  return file;
}

std::string JpegClaiming(std::uint16_t width, std::uint16_t height) {
  std::string file = JpegOf(TestColor());
  const std::size_t start = file.find("\xFF\xC0");  // SOF0: marker, length, precision, sizes
  const std::size_t size = start + 5;
  file[size] = static_cast<char>(height >> 8);
  file[size + 1] = static_cast<char>(height);
  file[size + 2] = static_cast<char>(width >> 8);
  file[size + 3] = static_cast<char>(width);
  return file;
}

}  // namespace fovea::testing
