#include "client/cli/image_folders.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "client/cli/endings.h"
#include "client/cli/files.h"
#include "client/cli/timed_images.h"

namespace fovea::cli {
namespace {

namespace fs = std::filesystem;

bool IsImage(const fs::path& path) {
  const std::string ending = LowerEnding(path.string());
  return ending == ".png" || ending == ".jpg" || ending == ".jpeg";
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
FrameList PairImages(const fs::path& color, const fs::path& depth) {
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

std::optional<FrameList> ListImageFolders(const fs::path& folder) {
  std::error_code error;
  for (const char* color : {"rgb", "color"}) {
    if (!fs::is_directory(folder / color, error) || !fs::is_directory(folder / "depth", error)) {
      continue;
    }
    FrameList list = PairImages(folder / color, folder / "depth");
    NoteAssociations(folder, &list);
    return list;
  }
  return std::nullopt;
}

}  // namespace fovea::cli
