#include "client/cli/bag/ros_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <vector>

#include "client/cli/bag/byte_reader.h"
#include "client/cli/camera_window.h"
#include "client/cli/distortion.h"
#include "client/image_files/image_files.h"

namespace fovea::cli {
namespace {

using image_files::EncodePng;

constexpr std::string_view kPng("\x89PNG\r\n\x1a\n", 8);

// Plain CDR, little-endian: numbers are aligned to their size, texts have a 0 at their end.
class CdrReader {
 public:
  explicit CdrReader(std::string_view message) : reader_(Body(message)) {}

  template <typename Value>
  Value Number() {
    reader_.Align(sizeof(Value));
    return reader_.Number<Value>();
  }
  std::string_view Bytes() {
    reader_.Align(sizeof(std::uint32_t));
    return reader_.Text();
  }
  std::string_view Text() {
    const std::string_view text = Bytes();
    return text.substr(0, text.find('\0'));
  }

 private:
  static std::string_view Body(std::string_view message) {
    constexpr std::string_view kLittleEndian("\x00\x01", 2);
    constexpr std::string_view kZstd("\x28\xB5\x2F\xFD", 4);
    constexpr std::size_t kHead = 4;
    if (message.starts_with(kZstd)) {
      throw std::invalid_argument(
          "its messages are compressed one by one (compression mode MESSAGE), which is not read: "
          "convert it with ros2 bag convert");
    }
    if (message.size() < kHead || !message.starts_with(kLittleEndian)) {
      throw std::invalid_argument("a message is not in little-endian CDR");
    }
    return message.substr(kHead);
  }

  ByteReader reader_;
};

Header ReadHeader(CdrReader& reader) {
  constexpr std::int64_t kNsPerSecond = 1'000'000'000;
  const std::int64_t seconds = reader.Number<std::int32_t>();
  const std::int64_t nanoseconds = reader.Number<std::uint32_t>();
  return {seconds * kNsPerSecond + nanoseconds, std::string(reader.Text())};
}

constexpr const char* kColor = "colour that is read (rgb8, bgr8, 8UC3, rgba8, bgra8, mono8, 8UC1)";
constexpr const char* kDepth = "depth that is read (16UC1, mono16, 32FC1)";
constexpr const char* kColorFile = "colour that is read (JPEG, PNG)";
constexpr const char* kDepthFile = "depth that is read (PNG, compressedDepth of 16UC1 or 32FC1)";

std::invalid_argument NoUse(const char* what, std::string_view encoding) {
  return std::invalid_argument(std::string("an image of encoding \"") +
                               std::string(encoding.substr(0, 64)) + "\" is no " + what);
}

struct Raw {
  std::string_view encoding, data;
  std::uint32_t width = 0, height = 0, step = 0;
  bool big_endian = false;
};

Raw ReadImage(std::string_view message) {
  CdrReader reader(message);
  ReadHeader(reader);
  Raw raw;
  raw.height = reader.Number<std::uint32_t>();
  raw.width = reader.Number<std::uint32_t>();
  raw.encoding = reader.Text();
  raw.big_endian = reader.Number<std::uint8_t>() != 0;
  raw.step = reader.Number<std::uint32_t>();
  raw.data = reader.Bytes();
  return raw;
}

// Of the message's bytes, which must outlive it.
cv::Mat PixelsOf(const Raw& raw, int type) {
  constexpr std::uint32_t kLargest = 1 << 15;
  if (raw.width == 0 || raw.height == 0 || raw.width > kLargest || raw.height > kLargest) {
    throw std::invalid_argument("an image's width or height is not from 1 to 32768");
  }
  const std::uint64_t row = std::uint64_t{raw.width} * CV_ELEM_SIZE(type);
  if (raw.step < row || raw.data.size() < std::uint64_t{raw.step} * raw.height) {
    throw std::invalid_argument("an image has fewer bytes than its size needs");
  }
  cv::Mat pixels(static_cast<int>(raw.height), static_cast<int>(raw.width), type);
  for (std::uint32_t y = 0; y < raw.height; ++y) {  // which may lie at any byte
    std::memcpy(pixels.ptr(static_cast<int>(y)), raw.data.data() + std::uint64_t{raw.step} * y,
                static_cast<std::size_t>(row));
  }
  return pixels;
}

cv::Mat Converted(const cv::Mat& pixels, int code) {
  cv::Mat converted;
  cv::cvtColor(pixels, converted, code);
  return converted;
}

cv::Mat UnitsOf(const cv::Mat& meters, double unit_m) {
  constexpr double kMostUnits = std::numeric_limits<std::uint16_t>::max();
  cv::Mat units(meters.size(), CV_16UC1);
  double nearest_m = std::numeric_limits<double>::infinity();
  for (int y = 0; y < meters.rows; ++y) {
    for (int x = 0; x < meters.cols; ++x) {
      const double depth_m = meters.at<float>(y, x);
      const double unit = std::round(depth_m / unit_m);
      units.at<std::uint16_t>(y, x) =
          unit > 0 && unit <= kMostUnits ? static_cast<std::uint16_t>(unit) : 0;
      if (depth_m > 0) nearest_m = std::min(nearest_m, depth_m);
    }
  }
  // Millimetres, most likely, which nobody would see in an image without depth.
  if (std::isfinite(nearest_m) && std::round(nearest_m / unit_m) > kMostUnits) {
    throw std::invalid_argument(
        fmt::format("the nearest depth of an image of 32FC1, which is in metres, is {:g} m, and 16 "
                    "bits hold {:g} m: check its unit",
                    nearest_m, kMostUnits * unit_m));
  }
  return units;
}

std::pair<std::string_view, std::string_view> ReadCompressed(std::string_view message) {
  CdrReader reader(message);
  ReadHeader(reader);
  const std::string_view format = reader.Text();
  return {format, reader.Bytes()};
}

CameraWindow ReadWindow(CdrReader& reader) {
  CameraWindow window;
  window.binning_x = reader.Number<std::uint32_t>();
  window.binning_y = reader.Number<std::uint32_t>();
  window.x_offset = reader.Number<std::uint32_t>();
  window.y_offset = reader.Number<std::uint32_t>();
  window.height = reader.Number<std::uint32_t>();
  window.width = reader.Number<std::uint32_t>();
  return window;
}

constexpr std::size_t kParameters = 12;  // before the file in compressedDepth

// PNG of A / depth + B, where A and B are the last of its parameters and 0 is none, as
// compressed_depth_image_transport writes it.
cv::Mat MetersOf(std::string_view compressed_depth) {
  ByteReader reader(compressed_depth.substr(0, kParameters));
  reader.Number<std::int32_t>();
  const auto a = reader.Number<float>(), b = reader.Number<float>();
  cv::Mat inverse;
  try {
    inverse = image_files::DecodeDepth(compressed_depth.substr(kParameters));
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument(error.what());
  }
  cv::Mat meters(inverse.size(), CV_32FC1);
  std::transform(
      inverse.begin<std::uint16_t>(), inverse.end<std::uint16_t>(), meters.begin<float>(),
      [&](std::uint16_t value) { return value == 0 ? 0 : a / (static_cast<float>(value) - b); });
  return meters;
}

}  // namespace

Header HeaderOf(std::string_view message) {
  CdrReader reader(message);
  return ReadHeader(reader);
}

std::string ColorFile(std::string_view message, bool compressed) {
  if (compressed) {
    const auto [format, file] = ReadCompressed(message);
    if (file.starts_with("\xff\xd8\xff") || file.starts_with(kPng)) return std::string(file);
    throw NoUse(kColorFile, format);
  }
  const Raw raw = ReadImage(message);
  const std::string_view encoding = raw.encoding;
  if (encoding == "bgr8" || encoding == "8UC3") return EncodePng(PixelsOf(raw, CV_8UC3));
  if (encoding == "rgb8") return EncodePng(Converted(PixelsOf(raw, CV_8UC3), cv::COLOR_RGB2BGR));
  if (encoding == "bgra8") return EncodePng(Converted(PixelsOf(raw, CV_8UC4), cv::COLOR_BGRA2BGR));
  if (encoding == "rgba8") return EncodePng(Converted(PixelsOf(raw, CV_8UC4), cv::COLOR_RGBA2BGR));
  if (encoding == "mono8" || encoding == "8UC1") return EncodePng(PixelsOf(raw, CV_8UC1));
  throw NoUse(kColor, encoding);
}

std::string DepthFile(std::string_view message, bool compressed, double unit_m) {
  if (compressed) {
    auto [format, file] = ReadCompressed(message);
    const std::string_view png = file.substr(std::min(kParameters, file.size()));
    if (format.starts_with("32FC1; compressedDepth") && png.starts_with(kPng)) {
      return EncodePng(UnitsOf(MetersOf(file), unit_m));
    }
    if (format.starts_with("16UC1; compressedDepth")) file = png;
    if (file.starts_with(kPng)) return std::string(file);
    throw NoUse(kDepthFile, format);
  }
  const Raw raw = ReadImage(message);
  if (raw.big_endian) throw std::invalid_argument("depth is big-endian");
  if (raw.encoding == "16UC1" || raw.encoding == "mono16")
    return EncodePng(PixelsOf(raw, CV_16UC1));
  if (raw.encoding == "32FC1") return EncodePng(UnitsOf(PixelsOf(raw, CV_32FC1), unit_m));
  throw NoUse(kDepth, raw.encoding);
}

Calibration CameraInfo(std::string_view message, bool rectified) {
  CdrReader reader(message);
  ReadHeader(reader);
  const auto height = reader.Number<std::uint32_t>(), width = reader.Number<std::uint32_t>();
  const std::string model(reader.Text());
  std::vector<double> coefficients;
  constexpr std::uint32_t kMostCoefficients = 64;
  const auto count = reader.Number<std::uint32_t>();
  if (count > kMostCoefficients) throw std::invalid_argument("camera_info has too long a d");
  for (std::uint32_t i = 0; i < count; ++i) coefficients.push_back(reader.Number<double>());
  std::array<double, 9> k{}, r{};
  std::array<double, 12> p{};
  for (double& value : k) value = reader.Number<double>();
  for (double& value : r) value = reader.Number<double>();
  for (double& value : p) value = reader.Number<double>();
  Calibration calibration{.fx = rectified ? p[0] : k[0],
                          .fy = rectified ? p[5] : k[4],
                          .cx = rectified ? p[2] : k[2],
                          .cy = rectified ? p[6] : k[5],
                          .width = static_cast<int>(width),
                          .height = static_cast<int>(height),
                          .distortion = {}};
  constexpr std::uint32_t kLargest = 1 << 15;
  if (!IsCamera(calibration) || width > kLargest || height > kLargest) {
    throw std::invalid_argument(std::string("it is of no camera (") + (rectified ? "P" : "K") +
                                ", width and height)");
  }
  Apply(ReadWindow(reader), &calibration);
  if (!rectified) calibration.distortion = MakeDistortion(model, coefficients);
  return calibration;
}

}  // namespace fovea::cli
