#include <array>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

#include "client/cli/bag/image_message.h"
#include "client/cli/bag/ros_images.h"
#include "client/image_files/image_files.h"

namespace fovea::cli {
namespace {

constexpr const char* kColor =
    "colour that is read (rgb8, bgr8, 8UC3, rgba8, bgra8, mono8, 8UC1, yuv422, uyvy, yuv422_yuy2, "
    "yuyv, bayer_rggb8, bayer_bggr8, bayer_gbrg8, bayer_grbg8)";
constexpr const char* kColorFile = "colour that is read (JPEG, PNG)";
constexpr int kAsItIs = -1;

struct Encoding {
  std::string_view name;
  int type;
  int conversion;  // OpenCV's
};

// As sensor_msgs/image_encodings has them: the letters of a Bayer pattern are those of its first
// two rows, and yuv422 is the older name of uyvy.
constexpr std::array kEncodings{
    Encoding{"bgr8", CV_8UC3, kAsItIs},
    Encoding{"8UC3", CV_8UC3, kAsItIs},
    Encoding{"rgb8", CV_8UC3, cv::COLOR_RGB2BGR},
    Encoding{"bgra8", CV_8UC4, cv::COLOR_BGRA2BGR},
    Encoding{"rgba8", CV_8UC4, cv::COLOR_RGBA2BGR},
    Encoding{"mono8", CV_8UC1, kAsItIs},
    Encoding{"8UC1", CV_8UC1, kAsItIs},
    Encoding{"yuv422", CV_8UC2, cv::COLOR_YUV2BGR_UYVY},
    Encoding{"uyvy", CV_8UC2, cv::COLOR_YUV2BGR_UYVY},
    Encoding{"yuv422_yuy2", CV_8UC2, cv::COLOR_YUV2BGR_YUYV},
    Encoding{"yuyv", CV_8UC2, cv::COLOR_YUV2BGR_YUYV},
    // OpenCV's names without this order of letters are of the pixels from the second row on.
    Encoding{"bayer_rggb8", CV_8UC1, cv::COLOR_BayerRGGB2BGR},
    Encoding{"bayer_bggr8", CV_8UC1, cv::COLOR_BayerBGGR2BGR},
    Encoding{"bayer_gbrg8", CV_8UC1, cv::COLOR_BayerGBRG2BGR},
    Encoding{"bayer_grbg8", CV_8UC1, cv::COLOR_BayerGRBG2BGR},
};

// Of pixels of two bytes and of patterns OpenCV makes black or other pixels where there are too
// few.
void RequireWholePattern(const Encoding& encoding, const cv::Mat& pixels) {
  constexpr int kLeastOfBayer = 3;
  if (encoding.type == CV_8UC2 && pixels.cols % 2 != 0) {
    throw std::invalid_argument("an image of " + std::string(encoding.name) +
                                " has an odd width, and two pixels share their colour");
  }
  if (encoding.name.starts_with("bayer") &&
      (pixels.cols < kLeastOfBayer || pixels.rows < kLeastOfBayer)) {
    throw std::invalid_argument("an image of " + std::string(encoding.name) +
                                " has fewer than 3x3 pixels");
  }
}

cv::Mat Converted(const Encoding& encoding, const cv::Mat& pixels) {
  if (encoding.conversion == kAsItIs) return pixels;
  RequireWholePattern(encoding, pixels);
  cv::Mat converted;
  cv::cvtColor(pixels, converted, encoding.conversion);
  return converted;
}

std::string FileOf(const CompressedImageMessage& image) {
  if (image.data.starts_with("\xff\xd8\xff") || image.data.starts_with("\x89PNG\r\n\x1a\n")) {
    return std::string(image.data);
  }
  throw NoUse(kColorFile, image.format);
}

}  // namespace

std::string ColorFile(std::string_view message, bool compressed) {
  if (compressed) return FileOf(ReadCompressedImage(message));
  const ImageMessage image = ReadImage(message);
  for (const Encoding& encoding : kEncodings) {
    if (encoding.name != image.encoding) continue;
    return image_files::EncodePng(Converted(encoding, PixelsOf(image, encoding.type)));
  }
  throw NoUse(kColor, image.encoding);
}

}  // namespace fovea::cli
