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
#include <utility>

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

// What is not read, for people.
class LeftOut {
 public:
  explicit LeftOut(std::string what) : what_(std::move(what)) {}

  void Add(const fs::path& path) {
    if (number_++ == 0) first_ = path.string();
  }
  void NoteIn(FrameList* list) const {
    if (number_ == 0) return;
    list->notes.push_back(
        fmt::format("{} are left out: {}, the first is {}", what_, number_, first_));
  }

 private:
  const std::string what_;
  std::size_t number_ = 0;
  std::string first_;
};

std::vector<fs::path> ImagesIn(const fs::path& folder, LeftOut* others) {
  std::vector<fs::path> images;
  for (const fs::path& path : FilesIn(folder)) {
    if (IsImage(path)) {
      images.push_back(path);
    } else if (!path.filename().string().starts_with('.')) {
      others->Add(path);
    }
  }
  return images;
}

std::vector<TimedImage> ListTimed(const std::vector<fs::path>& paths, LeftOut* without_time) {
  std::vector<TimedImage> images;
  for (const fs::path& path : paths) {
    const auto time_ns = ParseTime(path.stem().string());
    if (time_ns) {
      images.push_back({*time_ns, path.stem().string(), path.string()});
    } else {
      without_time->Add(path);
    }
  }
  return images;
}

FrameList PairByName(const fs::path& color, const std::vector<fs::path>& color_paths,
                     const fs::path& depth, const std::vector<fs::path>& depth_paths) {
  std::map<std::string, std::string> depths;
  for (const fs::path& path : depth_paths) depths[path.stem().string()] = path.string();
  FrameList list;
  std::set<std::string> names;
  for (const fs::path& path : color_paths) {
    const auto partner = depths.find(path.stem().string());
    if (partner == depths.end()) continue;
    names.insert(partner->first);
    list.frames.push_back({partner->first, path.string(), partner->second, {}});
  }
  const auto note = [&](std::size_t number, const fs::path& of, const fs::path& other) {
    if (number == 0) return;
    list.notes.push_back(fmt::format("{} images in {} have none of the same name in {}", number,
                                     of.string(), other.string()));
  };
  note(color_paths.size() - list.frames.size(), color, depth);
  note(depths.size() - names.size(), depth, color);
  return list;
}

// Images of one name are one frame; where times tell of more frames, they do: some of two cameras'
// may be equal by chance.
FrameList ListFolders(const fs::path& color, const fs::path& depth) {
  LeftOut others("files that are no .png, .jpg or .jpeg");
  const std::vector<fs::path> colors = ImagesIn(color, &others), depths = ImagesIn(depth, &others);
  FrameList list = PairByName(color, colors, depth, depths);
  if (list.frames.size() < colors.size() || list.frames.empty()) {
    LeftOut without_time("images whose name is no time");
    FrameList timed =
        PairByTime(ListTimed(colors, &without_time), ListTimed(depths, &without_time));
    if (timed.frames.size() > list.frames.size() || list.frames.empty()) list = std::move(timed);
    if (list.frames.empty() || list.frames.front().captured_at) without_time.NoteIn(&list);
  }
  others.NoteIn(&list);
  return list;
}

// Lists of pairs come with depth in units that are seldom millimetres.
void NoteAssociations(const fs::path& folder, FrameList* list) {
  for (const char* name :
       {"associations.txt", "associated.txt", "association.txt", "associate.txt"}) {
    if (!fs::exists(folder / name)) continue;
    list->notes.push_back((folder / name).string() +
                          " is not read: images are paired by their names or times, and depth is "
                          "in millimetres unless --depth-unit says otherwise (0.0002: TUM and "
                          "ICL-NUIM)");
  }
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
      NoteAssociations(input, &list);
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
