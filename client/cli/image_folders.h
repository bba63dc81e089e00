// Frames of folders of images: rgb or color, and depth.
#pragma once

#include <filesystem>
#include <optional>

#include "client/cli/frame_list.h"

namespace fovea::cli {

// Of images of one name or, where that gives more frames, of times that are their names; notes say
// what has no partner and what is not read. None where there are no such folders. Throws
// std::runtime_error where one cannot be read.
std::optional<FrameList> ListImageFolders(const std::filesystem::path& folder);

}  // namespace fovea::cli
