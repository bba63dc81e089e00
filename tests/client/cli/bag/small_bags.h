// Bags of images of two by one pixels, and what is read of them.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>

#include "client/cli/bag/bag.h"
#include "client/cli/bag/mcap.h"
#include "client/cli/files.h"
#include "tests/support/bag_writer.h"

namespace fovea::cli::small_bags {

inline constexpr std::int64_t kFirst_ns = 1'700'000'000'250'000'000, kMillisecond_ns = 1'000'000;
inline constexpr const char* kColor = "/camera/color/image_raw";
inline constexpr const char* kDepth = "/camera/aligned_depth_to_color/image_raw";

// Two by one pixels: red and dark blue; 1 m and 2.5 m.
inline const std::string kRgb{"\xFF\0\0\0\0\x40", 6}, kUnits{"\xE8\x03\xC4\x09", 4};

inline Bag Read(const std::string& bytes, const BagFlags& flags = {}) {
  return ReadBag({{"b.mcap", McapFile(McapInMemory(bytes))}}, flags);
}

// Why it, or one of its images, cannot be read.
inline std::string WhyNot(const std::string& bytes, const BagFlags& flags = {}) {
  try {
    for (const FrameFiles& frame : Read(bytes, flags).list.frames) {
      frame.read_color();
      frame.read_depth();
    }
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

inline cv::Mat Color(const FrameFiles& frame) { return DecodeColor(frame.read_color(), "c"); }
inline cv::Mat Depth(const FrameFiles& frame) { return DecodeDepth(frame.read_depth(), "d"); }

// A bag of one frame.
inline std::string BagOf(const std::string& color_type, const std::string& color,
                         const std::string& depth_type, const std::string& depth) {
  testing::BagWriter writer;
  writer.Add("/rgb", color_type, color);
  writer.Add("/depth", depth_type, depth);
  return writer.Finish();
}

}  // namespace fovea::cli::small_bags
