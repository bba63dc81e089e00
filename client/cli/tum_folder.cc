#include "client/cli/tum_folder.h"

#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "client/cli/files.h"
#include "client/cli/timed_images.h"

namespace fovea::cli {
namespace {

namespace fs = std::filesystem;

// Lines "time path", whose path may have spaces in it; # begins a comment.
std::vector<TimedImage> ReadTumList(const fs::path& list) {
  std::string text = ReadTextOfFolder(list.string());
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
  std::istringstream lines(text);
  std::vector<TimedImage> images;
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    std::string time, path;
    if (!(words >> time) || time.front() == '#') continue;
    const auto time_ns = ParseTime(time);
    std::getline(words >> std::ws, path);
    path.erase(path.find_last_not_of(" \t\r") + 1);
    if (!time_ns || path.empty()) {
      throw std::runtime_error(list.string() + ", line " + std::to_string(number) +
                               ": it is not \"time path\", for example \"1305031102.175304 "
                               "rgb/1305031102.175304.png\"");
    }
    images.push_back({*time_ns, time, (list.parent_path() / path).string()});
  }
  return images;
}

}  // namespace

std::optional<FrameList> ListTum(const fs::path& folder) {
  std::error_code error;
  const bool has_color = fs::exists(folder / "rgb.txt", error);
  const bool has_depth = fs::exists(folder / "depth.txt", error);
  if (!has_color && !has_depth) return std::nullopt;
  if (has_color != has_depth) {
    throw std::runtime_error(folder.string() + " has " + (has_color ? "rgb.txt" : "depth.txt") +
                             " of TUM without " + (has_color ? "depth.txt" : "rgb.txt"));
  }
  FrameList list = PairByTime(ReadTumList(folder / "rgb.txt"), ReadTumList(folder / "depth.txt"));
  list.depth_unit_m = 1.0 / 5000;
  return list;
}

}  // namespace fovea::cli
