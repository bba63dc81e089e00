#include "client/cli/frame_list.h"

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "client/cli/endings.h"
#include "client/cli/image_folders.h"
#include "client/cli/named_frames.h"
#include "client/cli/tum_folder.h"

namespace fovea::cli {

namespace fs = std::filesystem;

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
        " is neither a folder nor by its name a bag of ROS 2 (.mcap, .db3) or a bundle (.zip)" +
        (LowerEnding(folder) == ".bag" ? "; bags of ROS 1 have to be converted" : ""));
  }
  FrameList list = ListByName(input);
  if (!list.frames.empty()) {
    list.captured = ReadCaptureFile(folder);
    if (list.captured) list.depth_unit_m = list.captured->depth_unit_m;
    return list;
  }
  std::optional<FrameList> others = ListTum(input);
  if (!others) others = ListImageFolders(input);
  if (others) list = *std::move(others);
  if (!list.frames.empty()) return list;
  std::string notes;
  for (const std::string& note : list.notes) notes += "; " + note;
  throw std::runtime_error("no NAME_color.png, .jpg or .jpeg with NAME_depth.png in " + folder +
                           ", no rgb.txt and depth.txt of TUM, and no folders rgb (or color) and "
                           "depth with images" +
                           notes);
}

}  // namespace fovea::cli
