#include "client/cli/named_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "client/cli/endings.h"
#include "client/cli/files.h"

namespace fovea::cli {
namespace {

namespace fs = std::filesystem;

// What is before the ending, in letters of either case, where the text ends so, else empty.
std::string Before(const std::string& text, const std::string& ending) {
  if (text.size() <= ending.size() || !Lower(text).ends_with(ending)) return {};
  return text.substr(0, text.size() - ending.size());
}

std::string ColorName(const std::string& filename) {
  for (const char* ending : {"_color.png", "_color.jpg", "_color.jpeg"}) {
    if (std::string name = Before(filename, ending); !name.empty()) return name;
  }
  return {};
}

std::string DepthName(const std::string& filename) { return Before(filename, "_depth.png"); }

}  // namespace

bool IsOfAFrame(const std::string& filename) {
  return !ColorName(filename).empty() || !DepthName(filename).empty();
}

FrameList ListByName(const fs::path& folder) {
  FrameList list;
  std::map<std::string, std::string> depth_paths;  // by name
  const std::vector<fs::path> files = FilesIn(folder);
  for (const fs::path& path : files) {
    const std::string name = DepthName(path.filename().string());
    if (!name.empty()) depth_paths[name] = path.string();
  }
  std::set<std::string> names;
  for (const fs::path& path : files) {
    const std::string name = ColorName(path.filename().string());
    if (name.empty()) continue;
    names.insert(name);
    const auto depth = depth_paths.find(name);
    const std::string expected = (folder / (name + "_depth.png")).string();
    list.frames.push_back(
        {name, path.string(), depth == depth_paths.end() ? expected : depth->second, {}});
  }
  for (const auto& [name, path] : depth_paths) {
    if (!names.contains(name))
      list.notes.push_back(fmt::format("{} has no {}_color.png (or .jpg)", path, name));
  }
  std::sort(list.frames.begin(), list.frames.end(), [](const FrameFiles& a, const FrameFiles& b) {
    return std::tie(a.id, a.color_path) < std::tie(b.id, b.color_path);
  });
  return list;
}

}  // namespace fovea::cli
