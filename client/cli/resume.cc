#include "client/cli/resume.h"

#include <filesystem>
#include <stdexcept>

#include "client/cli/files.h"
#include "client/cli/json.h"

namespace fovea::cli {
namespace {

namespace fs = std::filesystem;

std::string RequestPath(const Batch& batch) {
  return (fs::path(batch.output) / kRequestName).string() + ".json";
}

// Whether a frame's files are all there, and no older than what they were made from: its images and
// the request, since a run that asks for something else may have ended before it came to this
// frame.
bool IsDone(const FrameFiles& files, const Batch& batch) {
  const Outputs outputs = OutputsOf(files.id, batch);
  for (const std::string& path :
       {outputs.json, outputs.labels, outputs.overlay, outputs.cloud, outputs.height_map}) {
    if (!path.empty() && !fs::exists(path)) return false;
  }
  const auto is_newer = [&](const std::string& path) {
    return fs::exists(path) && fs::last_write_time(path) > fs::last_write_time(outputs.json);
  };
  if (is_newer(RequestPath(batch))) return false;
  const bool are_files = !files.read_color && !files.sent_before;
  return are_files ? !is_newer(files.color_path) && !is_newer(files.depth_path)
                   : !is_newer(batch.input);
}

}  // namespace

Outputs OutputsOf(const std::string& name, const Batch& batch) {
  Outputs outputs;
  outputs.extras = batch.extras;
  outputs.json_masks = batch.json_masks;
  if (batch.output.empty()) {
    outputs.json = std::string(kStandardOutput);
    return outputs;
  }
  const std::string prefix = (fs::path(batch.output) / name).string();
  outputs.json = prefix + ".json";
  if (batch.labels) outputs.labels = prefix + ".png";
  if (batch.overlays) outputs.overlay = prefix + "_overlay.jpg";
  if (batch.height_maps) outputs.height_map = prefix + "_height.jpg";
  if (!batch.clouds.empty()) outputs.cloud = prefix + "." + batch.clouds;
  return outputs;
}

void SaveRequest(const Batch& batch, const FrameSettings& settings) {
  const std::string path = RequestPath(batch);
  const std::string asked = ToJson(CommonRequest(settings));
  if (batch.resume && fs::exists(path)) {
    if (ReadFile(path) == asked) return;
    throw std::invalid_argument("--resume: the results in " + batch.output +
                                " are answers to another request, see " + path);
  }
  WriteFile(path + ".part", asked);
  fs::rename(path + ".part", path);
}

std::size_t LeaveOutDone(const Batch& batch, std::vector<FrameFiles>* frames) {
  if (!batch.resume || batch.output.empty()) return 0;
  return std::erase_if(*frames, [&](const FrameFiles& files) { return IsDone(files, batch); });
}

}  // namespace fovea::cli
