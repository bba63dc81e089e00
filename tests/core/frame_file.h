// Frames in a file, bit for bit, for programs that must look at the same ones.
#pragma once

#include <cstdint>
#include <istream>
#include <opencv2/core.hpp>
#include <ostream>

#include "core/types/rgbd_frame.h"

namespace fovea {

inline void WriteFrame(std::ostream& file, const RgbdFrame& frame) {
  const auto write = [&](const void* bytes, std::size_t size) {
    file.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  };
  const cv::Size size = frame.depth_m.size();
  write(&size, sizeof size);
  write(&frame.intrinsics, sizeof frame.intrinsics);
  const cv::Mat color = frame.color_rgb.clone(), depth = frame.depth_m.clone();  // without gaps
  write(color.data, color.total() * color.elemSize());
  write(depth.data, depth.total() * depth.elemSize());
}

// False at the end of the file.
inline bool ReadFrame(std::istream& file, RgbdFrame& frame) {
  const auto read = [&](void* bytes, std::size_t size) {
    file.read(static_cast<char*>(bytes), static_cast<std::streamsize>(size));
  };
  cv::Size size;
  read(&size, sizeof size);
  if (!file) return false;
  read(&frame.intrinsics, sizeof frame.intrinsics);
  frame.color_rgb = cv::Mat(size, CV_8UC3);
  frame.depth_m = cv::Mat(size, CV_32FC1);
  read(frame.color_rgb.data, frame.color_rgb.total() * frame.color_rgb.elemSize());
  read(frame.depth_m.data, frame.depth_m.total() * frame.depth_m.elemSize());
  return file.good();
}

}  // namespace fovea
