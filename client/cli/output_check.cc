#include "client/cli/output_check.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>

#include "client/cli/endings.h"

namespace fovea::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void FailToWrite(const std::string& flag, const std::string& path,
                              const std::string& why) {
  throw std::invalid_argument(flag + ": cannot write " + path + ": " + why);
}

void RequireWritableFolder(const std::string& flag, const std::string& path, fs::path folder) {
  if (folder.empty()) folder = ".";
  std::error_code error;
  if (!fs::is_directory(folder, error))
    FailToWrite(flag, path, "there is no folder " + folder.string());
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    FailToWrite(flag, path, "folder " + folder.string() + ": " + std::strerror(errno));
  }
}

// A file that is there is overwritten, which needs no right to its folder.
void RequireWritable(const std::string& flag, const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) FailToWrite(flag, path, "it is a folder");
  if (!fs::exists(path, error)) RequireWritableFolder(flag, path, fs::path(path).parent_path());
  if (fs::exists(path, error) && access(path.c_str(), W_OK) != 0) {
    FailToWrite(flag, path, std::strerror(errno));
  }
}

void RequireOther(const std::string& flag, const std::string& path, const FrameFiles& files,
                  const ReadFiles& others) {
  std::error_code error;  // of files that are not there
  for (const std::string& input : {files.color_path, files.depth_path}) {
    if (fs::equivalent(path, input, error)) FailToWrite(flag, path, "it is an image of the frame");
  }
  for (const auto& [other, input] : others) {
    if (fs::equivalent(path, input, error))
      FailToWrite(flag, path, "it is what " + other + " names");
  }
}

void RequireImageFormat(const std::string& flag, const std::string& path) {
  const std::string extension = fs::path(path).extension().string();
  if (extension.empty()) FailToWrite(flag, path, "give it an extension, for example .png");
  if (IsPngName(path) || IsJpegName(path)) return;
  FailToWrite(flag, path, "unknown image format " + extension + "; end it in .png or .jpg");
}

// Numbers must come back as they were.
void RequireLossless(const std::string& flag, const std::string& path) {
  RequireImageFormat(flag, path);
  if (!IsPngName(path))
    FailToWrite(flag, path, "labels need a format without loss; end it in .png");
}

}  // namespace

void MakeFolder(const std::string& flag, const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) FailToWrite(flag, path, error.message());
  RequireWritableFolder(flag, path, path);
}

void CheckOutputs(const Outputs& outputs, const FrameFiles& files, const ReadFiles& others) {
  std::map<fs::path, const char*> written;
  const auto check = [&](const char* flag, const std::string& path) {
    if (path.empty() || path == kStandardOutput) return;
    RequireWritable(flag, path);
    RequireOther(flag, path, files, others);
    std::error_code error;  // of /dev/stdout where it is a pipe
    const fs::path canonical = fs::weakly_canonical(fs::absolute(path), error);
    const auto [other, is_new] = written.emplace(error ? fs::path(path) : canonical, flag);
    if (!is_new) FailToWrite(flag, path, std::string("it is what ") + other->second + " writes");
  };
  if (!outputs.labels.empty()) RequireLossless("--labels", outputs.labels);
  if (!outputs.overlay.empty()) RequireImageFormat("--overlay", outputs.overlay);
  if (!outputs.height_map.empty()) RequireImageFormat("--height-map", outputs.height_map);
  if (!outputs.cloud.empty()) {
    const std::string ending = fs::path(outputs.cloud).extension().string();
    CheckCloudFormat(ending.empty() ? "" : ending.substr(1));
  }
  check("--labels", outputs.labels);
  check("--json", outputs.json);
  check("--overlay", outputs.overlay);
  check("--cloud", outputs.cloud);
  check("--height-map", outputs.height_map);
  if (!outputs.steps.empty()) MakeFolder("--explain", outputs.steps);
  if (outputs.saliency_prefix.empty()) return;
  for (const char* map : {"_color.png", "_depth.png"}) {
    check("--saliency", outputs.saliency_prefix + map);
  }
}

void CheckCloudFormat(const std::string& ending) {
  if (Lower(ending) == "ply" || Lower(ending) == "pcd") return;
  throw std::invalid_argument("--cloud: \"" + ending +
                              "\" is not a kind of cloud that is written: ply or pcd");
}

void PrepareFolder(const std::string& input, const std::vector<FrameFiles>& frames,
                   const std::string& output) {
  std::set<fs::path> with_inputs{input};
  for (const FrameFiles& frame : frames) {
    if (!frame.read_color) with_inputs.insert(fs::path(frame.color_path).parent_path());
    if (!frame.read_depth) with_inputs.insert(fs::path(frame.depth_path).parent_path());
  }
  for (const fs::path& folder : with_inputs) {
    std::error_code error;  // where there is no `output` yet
    if (!fs::equivalent(folder, output, error)) continue;
    throw std::invalid_argument("--output: " + output +
                                " is a folder of --input, whose files could be overwritten; give "
                                "another one");
  }
  MakeFolder("--output", output);
}

}  // namespace fovea::cli
