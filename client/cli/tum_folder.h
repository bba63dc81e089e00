// Frames as the TUM RGB-D benchmark has them: lists of images with their times.
#pragma once

#include <filesystem>
#include <optional>

#include "client/cli/frame_list.h"

namespace fovea::cli {

// Of rgb.txt and depth.txt, with depth in units of 1/5000 m; none where there is neither.
// Throws std::runtime_error where one is missing (its folders alone say neither times nor the unit
// of depth), cannot be read or has a line that is not "time path".
std::optional<FrameList> ListTum(const std::filesystem::path& folder);

}  // namespace fovea::cli
