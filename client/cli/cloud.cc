#include "client/cli/cloud.h"

#include <array>
#include <bit>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "client/cli/palette.h"

namespace fovea::cli {
namespace {

static_assert(std::endian::native == std::endian::little, "the file is little-endian");

std::string Header(std::size_t num_points) {
  return "ply\nformat binary_little_endian 1.0\n"
         "comment metres; camera frame: x right, y down, z forward\n"
         "element vertex " +
         std::to_string(num_points) +
         "\nproperty float x\nproperty float y\nproperty float z\n"
         "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";
}

// Half true colour and half the object's; the background loses a third of its light.
cv::Vec3b Shade(const cv::Vec3b& bgr, std::uint32_t label) {
  if (label == 0) return bgr * 0.65;
  const cv::Scalar tint = ColorOf(label);
  return cv::Vec3b(cv::saturate_cast<std::uint8_t>(0.5 * bgr[0] + 0.5 * tint[0]),
                   cv::saturate_cast<std::uint8_t>(0.5 * bgr[1] + 0.5 * tint[1]),
                   cv::saturate_cast<std::uint8_t>(0.5 * bgr[2] + 0.5 * tint[2]));
}

void AppendPoint(const std::array<float, 3>& position, const cv::Vec3b& bgr, std::string* ply) {
  ply->append(reinterpret_cast<const char*>(position.data()), sizeof position);
  for (const int channel : {2, 1, 0}) ply->push_back(static_cast<char>(bgr[channel]));
}

}  // namespace

std::string MakePly(const cv::Mat& color, const std::vector<DepthPoint>& points,
                    const cv::Mat& labels) {
  if (color.size() != labels.size()) throw std::runtime_error("colour and labels differ in size");
  cv::Mat wide_labels;
  labels.convertTo(wide_labels, CV_16U);
  std::string ply = Header(points.size());
  for (const auto& [position, pixel] : points) {
    AppendPoint({static_cast<float>(position[0]), static_cast<float>(position[1]),
                 static_cast<float>(position[2])},
                Shade(color.at<cv::Vec3b>(pixel), wide_labels.at<std::uint16_t>(pixel)), &ply);
  }
  return ply;
}

}  // namespace fovea::cli
