// Labelled frames as files.
#pragma once

#include <filesystem>
#include <string>

#include "tests/support/labelled_frame.h"

namespace fovea::scenes {

// Grey or BGR, by the ending of `path`. Throws std::runtime_error, which names the file, if it
// cannot be written.
void WriteImage(const std::filesystem::path& path, const cv::Mat& image);

// Writes `<name>_color.png` (8-bit RGB), `<name>_depth.png` (16-bit, millimetres, 0 = none),
// `<name>_label.png` (8-bit, 0 = not an object, k = object k) and `<name>.json` (intrinsics,
// gravity, supports, and the objects with pose and size; camera frame, metres). The folder must
// exist. Throws std::runtime_error, which names the file, if one cannot be written.
void WriteFrame(const std::filesystem::path& folder, const std::string& name,
                const LabelledFrame& labelled);

}  // namespace fovea::scenes
