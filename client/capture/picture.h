#pragma once

#include <chrono>
#include <cstdint>
#include <opencv2/core/mat.hpp>

namespace fovea::capture {

// Colour and depth that the camera took at the same time.
struct Picture {
  cv::Mat color;  // CV_8UC3, R first
  cv::Mat depth;  // CV_16UC1 in units of `depth_unit_m`, 0 = not measured
  double depth_unit_m = 0.001;
  std::uint64_t number = 0;                           // 1, 2, … over the whole run
  std::uint64_t device_time_us = 0;                   // of the depth image, by the camera's clock
  std::chrono::system_clock::time_point captured_at;  // when both had arrived
  std::chrono::steady_clock::time_point arrived;      // the same, for measuring
};

}  // namespace fovea::capture
