// Frames of 640×480 to time stages on: recorded ones where they are, else a generated one.
#pragma once

#include <string>
#include <vector>

#include "core/types/rgbd_frame.h"

namespace fovea {

// Three tables of growing clutter and a floor.
const std::vector<std::string>& FrameNames();

// What a frame of this name really is: its name, or that a generated one stands for it.
std::string SourceOf(const std::string& frame);

// CV_8UC3, R first.
cv::Mat ReadColor(const std::string& frame);

// CV_32FC1, metres, NaN = none.
cv::Mat ReadDepth(const std::string& frame);

RgbdFrame ReadFrame(const std::string& frame);

}  // namespace fovea
