#include "client/capture/save_folder.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "client/cli/named_frames.h"
#include "client/cli/output_check.h"

namespace fovea::capture {

void PrepareSaveFolder(const std::string& folder) {
  if (folder.empty()) return;
  std::error_code error;  // of a folder that is not there or cannot be read: making it says why
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!cli::IsOfAFrame(name)) continue;
    throw std::invalid_argument(
        fmt::format("--save: {} holds frames already, such as {}; choose a folder without frames",
                    folder, name));
  }
  cli::MakeFolder("--save", folder);
}

}  // namespace fovea::capture
