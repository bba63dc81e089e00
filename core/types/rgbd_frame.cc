#include "core/types/rgbd_frame.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace fovea {
namespace {

void Require(bool holds, const std::string& message) {
  if (!holds) throw std::invalid_argument(message);
}

void RequireFocalLength(double value, const std::string& name) {
  Require(std::isfinite(value) && value > 0,
          "intrinsics." + name + ": " + std::to_string(value) + " is not a positive number");
}

std::string SizeOf(const cv::Mat& image) {
  return std::to_string(image.cols) + "x" + std::to_string(image.rows);
}

}  // namespace

void Validate(const RgbdFrame& frame) {
  Require(!frame.color_rgb.empty(), "color: the image is empty");
  Require(frame.color_rgb.type() == CV_8UC3, "color: must have three 8-bit channels");
  Require(!frame.depth_m.empty(), "depth: the image is empty");
  Require(frame.depth_m.type() == CV_32FC1, "depth: must have one 32-bit float channel");
  Require(frame.color_rgb.size() == frame.depth_m.size(),
          "depth: its size " + SizeOf(frame.depth_m) + " differs from colour's " +
              SizeOf(frame.color_rgb) + "; depth must be registered to colour");

  RequireFocalLength(frame.intrinsics.fx_px, "fx_px");
  RequireFocalLength(frame.intrinsics.fy_px, "fy_px");
  Require(std::isfinite(frame.intrinsics.cx_px), "intrinsics.cx_px: is not a finite number");
  Require(std::isfinite(frame.intrinsics.cy_px), "intrinsics.cy_px: is not a finite number");

  if (frame.gravity) {
    const float length = frame.gravity->norm();
    Require(std::isfinite(length) && std::abs(length - 1.0F) <= 0.1F,
            "gravity: its length must be 1, is " + std::to_string(length));
  }
}

}  // namespace fovea
