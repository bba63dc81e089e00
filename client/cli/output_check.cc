#include "client/cli/output_check.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

namespace fovea::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void Fail(const std::string& flag, const std::string& path, const std::string& why) {
  throw std::invalid_argument(flag + ": cannot write " + path + ": " + why);
}

void RequireWritableFolder(const std::string& flag, const std::string& path, fs::path folder) {
  if (folder.empty()) folder = ".";
  std::error_code error;
  if (!fs::is_directory(folder, error)) Fail(flag, path, "there is no folder " + folder.string());
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    Fail(flag, path, "folder " + folder.string() + ": " + std::strerror(errno));
  }
}

// A file that is there is overwritten, which needs no right to its folder.
void RequireWritable(const std::string& flag, const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) Fail(flag, path, "it is a folder");
  if (!fs::exists(path, error)) RequireWritableFolder(flag, path, fs::path(path).parent_path());
  if (fs::exists(path, error) && access(path.c_str(), W_OK) != 0) {
    Fail(flag, path, std::strerror(errno));
  }
}

void RequireOther(const std::string& flag, const std::string& path, const FrameFiles& files) {
  for (const std::string& input : {files.color_path, files.depth_path}) {
    std::error_code error;  // of files that are not there
    if (fs::equivalent(path, input, error)) Fail(flag, path, "it is an image of the frame");
  }
}

void RequireImageFormat(const std::string& flag, const std::string& path) {
  const std::string extension = fs::path(path).extension().string();
  if (extension.empty()) Fail(flag, path, "give it an extension, for example .png");
  if (!cv::haveImageWriter(path)) Fail(flag, path, "unknown image format " + extension);
}

// Makes it where it is missing.
void MakeFolder(const std::string& flag, const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) Fail(flag, path, error.message());
  RequireWritableFolder(flag, path, path);
}

}  // namespace

void CheckOutputs(const OutputPaths& paths, const FrameFiles& files) {
  const auto check = [&](const char* flag, const std::string& path, bool is_image) {
    if (path.empty()) return;
    if (is_image) RequireImageFormat(flag, path);
    RequireWritable(flag, path);
    RequireOther(flag, path, files);
  };
  check("--labels", paths.labels, true);
  check("--json", paths.json, false);
  check("--overlay", paths.overlay, true);
  check("--cloud", paths.cloud, false);
  if (!paths.steps.empty()) MakeFolder("--explain", paths.steps);
  if (paths.saliency_prefix.empty()) return;
  for (const char* map : {"_color.png", "_depth.png"}) {
    check("--saliency", paths.saliency_prefix + map, true);
  }
}

void PrepareFolder(const std::string& input, const std::string& output) {
  std::error_code error;  // where there is no `output` yet
  if (fs::equivalent(input, output, error)) {
    throw std::invalid_argument("--output: " + output +
                                " is the folder of --input, whose files NAME.png and NAME.json "
                                "would be overwritten; give another one");
  }
  MakeFolder("--output", output);
}

}  // namespace fovea::cli
