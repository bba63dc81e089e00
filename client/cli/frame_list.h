// Which frames a folder holds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "client/cli/capture_file.h"
#include "client/cli/request.h"

namespace fovea::cli {

struct FrameList {
  std::vector<FrameFiles> frames;       // in the order in which they are to be answered
  std::vector<std::string> notes;       // for people: what has no partner
  double depth_unit_m = 0.001;          // metres per unit of depth, as such folders have it
  std::optional<CaptureFile> captured;  // of what fovea-capture kept; has the unit, too
};

// Of a folder, by what is in it:
// - NAME_color.(png|jpg|jpeg) with NAME_depth.png, and fovea_capture.json where fovea-capture made
//   them,
// - TUM RGB-D: rgb.txt and depth.txt with lines "time path", units of 1/5000 m,
// - folders rgb or color, and depth, with images of one name, or, where that gives more frames,
//   named by times in seconds ("12.345678.png") or as whole numbers of milli-, micro- or
//   nanoseconds.
// Images with times are paired with the nearest one at most 20 ms away. A depth path is there
// whether the file is or not. Throws std::runtime_error where it is none of these.
FrameList ListFrames(const std::string& folder);

// Of the files beside the results that say what was asked, and of which frames.
inline constexpr const char *kRequestName = "fovea_request", *kInputName = "fovea_input";

// Frames of one name, or of those two, get one each, so that no result takes the place of another:
// NAME, NAME_2, … Returns how many were renamed.
std::size_t NameApart(std::vector<FrameFiles>& frames);

}  // namespace fovea::cli
