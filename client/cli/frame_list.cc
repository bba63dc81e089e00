#include "client/cli/frame_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <tuple>

#include "client/cli/endings.h"
#include "client/cli/files.h"
#include "client/cli/timed_images.h"

namespace fovea::cli {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> FilesIn(const fs::path& folder) {
  std::error_code error;
  fs::directory_iterator entries(folder, error);
  if (error) throw std::runtime_error("cannot read " + folder.string() + ": " + error.message());
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : entries) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

bool IsImage(const fs::path& path) {
  const std::string ending = LowerEnding(path.string());
  return ending == ".png" || ending == ".jpg" || ending == ".jpeg";
}

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

FrameList ListTum(const fs::path& folder) {
  FrameList list = PairByTime(ReadTumList(folder / "rgb.txt"), ReadTumList(folder / "depth.txt"));
  list.depth_unit_m = 1.0 / 5000;
  return list;
}

std::vector<TimedImage> ListTimed(const fs::path& folder) {
  std::vector<TimedImage> images;
  for (const fs::path& path : FilesIn(folder)) {
    const auto time_ns = ParseTime(path.stem().string());
    if (!IsImage(path) || !time_ns) continue;
    images.push_back({*time_ns, path.stem().string(), path.string()});
  }
  return images;
}

// Images of one name are one frame; where times tell of more frames, they do: some of two cameras'
// may be equal by chance.
FrameList ListFolders(const fs::path& color, const fs::path& depth) {
  std::map<std::string, std::string> depth_paths;
  for (const fs::path& path : FilesIn(depth)) {
    if (IsImage(path)) depth_paths[path.stem().string()] = path.string();
  }
  FrameList list;
  std::size_t num_alone = 0;
  for (const fs::path& path : FilesIn(color)) {
    if (!IsImage(path)) continue;
    const auto partner = depth_paths.find(path.stem().string());
    if (partner == depth_paths.end()) {
      ++num_alone;
      continue;
    }
    list.frames.push_back({path.stem().string(), path.string(), partner->second, {}});
  }
  if (num_alone > 0 || list.frames.empty()) {
    FrameList timed = PairByTime(ListTimed(color), ListTimed(depth));
    if (timed.frames.size() > list.frames.size() || list.frames.empty()) return timed;
    list.notes.push_back(std::to_string(num_alone) + " images in " + color.string() +
                         " have none of the same name in " + depth.string());
  }
  return list;
}

}  // namespace

bool IsOfAFrame(const std::string& filename) {
  return !ColorName(filename).empty() || !DepthName(filename).empty();
}

std::size_t NameApart(std::vector<FrameFiles>& frames) {
  std::set<std::string> names;
  for (const FrameFiles& frame : frames) names.insert(frame.id);
  // The last that a name was given.
  std::map<std::string, int> number_of{{kRequestName, 1}, {kInputName, 1}};
  std::size_t num_renamed = 0;
  for (FrameFiles& frame : frames) {
    const auto [number, is_first] = number_of.try_emplace(frame.id, 1);
    if (is_first) continue;
    std::string name;
    do {
      name = frame.id + "_" + std::to_string(++number->second);
    } while (!names.insert(name).second);
    frame.id = name;
    ++num_renamed;
  }
  return num_renamed;
}

FrameList ListFrames(const std::string& folder) {
  const fs::path input(folder);
  if (fs::is_regular_file(input)) {
    throw std::runtime_error(
        folder +
        " is neither a folder nor by its name a bag of ROS 2 (.mcap, .db3) or "
        "a bundle (.zip)" +
        (LowerEnding(folder) == ".bag" ? "; bags of ROS 1 have to be converted" : ""));
  }
  FrameList list = ListByName(input);
  if (!list.frames.empty()) {
    list.captured = ReadCaptureFile(folder);
    if (list.captured) list.depth_unit_m = list.captured->depth_unit_m;
    return list;
  }
  std::error_code error;
  const bool has_color = fs::exists(input / "rgb.txt", error);
  const bool has_depth = fs::exists(input / "depth.txt", error);
  if (has_color != has_depth) {
    // Its folders alone say neither times nor the unit of depth.
    throw std::runtime_error(folder + " has " + (has_color ? "rgb.txt" : "depth.txt") +
                             " of TUM without " + (has_color ? "depth.txt" : "rgb.txt"));
  }
  if (has_color) {
    list = ListTum(input);
  } else {
    for (const char* color : {"rgb", "color"}) {
      if (!fs::is_directory(input / color, error) || !fs::is_directory(input / "depth", error)) {
        continue;
      }
      list = ListFolders(input / color, input / "depth");
      break;
    }
  }
  if (!list.frames.empty()) return list;
  std::string notes;
  for (const std::string& note : list.notes) notes += "; " + note;
  throw std::runtime_error("no NAME_color.png, .jpg or .jpeg with NAME_depth.png in " + folder +
                           ", no rgb.txt and depth.txt of TUM, and no folders rgb (or color) and "
                           "depth with images" +
                           notes);
}

}  // namespace fovea::cli
