#include "client/capture/save_folder.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "client/cli/frame_list.h"

namespace fovea::capture {

void RequireNoFramesIn(const std::string& folder) {
  std::error_code error;  // of a folder that is not there or cannot be read: making it says why
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!cli::IsOfAFrame(name)) continue;
    throw std::invalid_argument(
        fmt::format("--save: {} holds frames already, such as {}; choose a folder without frames",
                    folder, name));
  }
}

}  // namespace fovea::capture
