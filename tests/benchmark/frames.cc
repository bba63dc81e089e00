#include "tests/benchmark/frames.h"

#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/support/data_path.h"

namespace fovea {
namespace {

cv::Mat GeneratedColor() {
  cv::Mat rgb(480, 640, CV_8UC3, cv::Scalar(120, 110, 90));
  cv::RNG random(7);
  for (int i = 0; i < 15; ++i) {
    const cv::Point center(random.uniform(80, 560), random.uniform(80, 400));
    cv::circle(rgb, center, random.uniform(10, 60),
               {random.uniform(0., 255.), random.uniform(0., 255.), random.uniform(0., 255.)}, -1);
  }
  cv::Mat noise(rgb.size(), CV_8UC3);
  random.fill(noise, cv::RNG::NORMAL, 8, 3);
  return rgb + noise;
}

}  // namespace

const std::vector<std::string>& FrameNames() {
  static const std::vector<std::string> names{"osd/learn0", "osd/learn40", "osd/test58",
                                              "floor/floor1"};
  return names;
}

std::string SourceOf(const std::string& frame) {
  const bool is_recorded = DataPath(frame + "_color.png") && DataPath(frame + "_depth.png");
  return is_recorded ? frame : "generated, there is no " + frame;
}

cv::Mat ReadColor(const std::string& frame) {
  const auto path = DataPath(frame + "_color.png");
  if (!path) return GeneratedColor();
  cv::Mat rgb;
  cv::cvtColor(cv::imread(path->string()), rgb, cv::COLOR_BGR2RGB);
  return rgb;
}

cv::Mat ReadDepth(const std::string& frame) {
  cv::Mat depth;
  if (const auto path = DataPath(frame + "_depth.png")) {
    cv::imread(path->string(), cv::IMREAD_UNCHANGED).convertTo(depth, CV_32F, 1e-3);
    depth.setTo(std::numeric_limits<float>::quiet_NaN(), depth == 0);
  } else {
    cv::cvtColor(GeneratedColor(), depth, cv::COLOR_RGB2GRAY);
    depth.convertTo(depth, CV_32F, 1 / 100.0, 0.5);
  }
  return depth;
}

RgbdFrame ReadFrame(const std::string& frame) {
  return {ReadColor(frame), ReadDepth(frame), {525, 525, 319.5, 239.5}, std::nullopt};
}

}  // namespace fovea
