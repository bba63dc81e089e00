// Frames of other people's cameras and rooms, with boxes that were drawn by hand.
#pragma once

#include <filesystem>
#include <opencv2/core/types.hpp>
#include <string>
#include <vector>

#include "core/types/rgbd_frame.h"

namespace fovea::evaluation {

struct BoxedObject {
  std::string name;
  cv::Rect box;  // of the visible part, pixels of the colour image
  // Small, ambiguous, flat, in the background or a container: need not be found, and what finds it
  // is no mistake.
  bool optional = false;
};

struct BoxedFrame {
  std::string source;  // the folder's name
  std::string name;
  RgbdFrame frame;
  std::vector<BoxedObject> objects;
};

// The frames of all sources in a folder, or of the one that it is, by source and name: `boxes.json`
// maps a frame's name to its objects (`name`, `box` [x0, y0, x1, y1], x1 and y1 exclusive, `small`
// for optional; other keys are for information), `intrinsics.txt` holds fx,fy,cx,cy, and
// `<name>_color.png` or `.jpg` and `<name>_depth.png` (16 bits, millimetres) are the images. Throws
// std::runtime_error, which names the file, if there is none or one is not so.
std::vector<BoxedFrame> LoadBoxedFrames(const std::filesystem::path& folder);

}  // namespace fovea::evaluation
