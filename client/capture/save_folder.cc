#include "client/capture/save_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace fovea::capture {
namespace {

// As `fovea detect --input` finds them.
bool IsOfAFrame(const std::string& filename) {
  constexpr std::array kEndings{"_color.png", "_color.jpg", "_color.jpeg", "_depth.png"};
  return std::any_of(kEndings.begin(), kEndings.end(),
                     [&](const char* ending) { return filename.ends_with(ending); });
}

}  // namespace

void RequireNoFramesIn(const std::string& folder) {
  std::error_code error;  // of a folder that is not there or cannot be read: making it says why
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!IsOfAFrame(name)) continue;
    throw std::invalid_argument(
        fmt::format("--save: {} holds frames already, such as {}; choose a folder without frames",
                    folder, name));
  }
}

}  // namespace fovea::capture
