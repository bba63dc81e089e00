// Frames by the names of their images: NAME_color.(png|jpg|jpeg) with NAME_depth.png.
#pragma once

#include <filesystem>
#include <string>

#include "client/cli/frame_list.h"

namespace fovea::cli {

// Sorted by name; a depth path is there whether the file is or not, and notes say what has no
// colour. Throws std::runtime_error where the folder cannot be read.
FrameList ListByName(const std::filesystem::path& folder);

// Whether a file of this name is an image of such a frame.
bool IsOfAFrame(const std::string& filename);

}  // namespace fovea::cli
