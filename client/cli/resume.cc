#include "client/cli/resume.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "client/cli/files.h"
#include "client/cli/json.h"

namespace fovea::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string RequestPath(const Batch& batch) {
  return (fs::path(batch.output) / kRequestName).string() + ".json";
}

std::string InputPath(const Batch& batch) {
  return (fs::path(batch.output) / kInputName).string() + ".json";
}

void Replace(const std::string& path, const std::string& text) {
  WriteFile(path + ".part", text);
  fs::rename(path + ".part", path);
}

// What the request does not say of a run: which frames are meant, and what overlays show.
json InputOf(const Batch& batch) {
  json input{{"input", fs::weakly_canonical(fs::absolute(batch.input)).string()},
             {"color_topic", batch.color_topic},
             {"depth_topic", batch.depth_topic},
             {"show", nullptr}};  // there are no overlays
  const OverlayExtras& extras = batch.extras;
  if (!batch.overlays) return input;
  input["show"] = {{"seeds", extras.seeds},
                   {"saliency", extras.saliency},
                   {"rejected", extras.rejected},
                   {"grasps", extras.grasps},
                   {"collisions", extras.collisions}};
  return input;
}

// Results that were made before this file was written go with whatever there is.
void RequireSameInput(const Batch& batch, json* input) {
  const std::string path = InputPath(batch);
  if (!fs::exists(path)) return;
  const json before = json::parse(ReadFile(path), nullptr, /*allow_exceptions=*/false);
  const auto is_same = [&](const char* name) {
    return before.is_object() && before.value(name, json()) == (*input)[name];
  };
  const auto refuse = [&](const std::string& what) {
    throw std::invalid_argument("--resume: the results in " + batch.output + what + ", see " +
                                path);
  };
  for (const char* name : {"input", "color_topic", "depth_topic"}) {
    if (!is_same(name)) refuse(" are of the frames of another input");
  }
  const json shown = before.value("show", json());
  if ((*input)["show"].is_null()) (*input)["show"] = shown;  // those overlays stay
  if (!shown.is_null() && !is_same("show")) refuse(" have overlays of another --show");
}

void SaveInput(const Batch& batch) {
  json input = InputOf(batch);
  if (batch.resume) RequireSameInput(batch, &input);
  constexpr int kIndent = 2;
  Replace(InputPath(batch),
          input.dump(kIndent, ' ', /*ensure_ascii=*/false, json::error_handler_t::replace) + "\n");
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
  const bool goes_on = batch.resume && fs::exists(path);
  if (goes_on && ReadFile(path) != asked) {
    throw std::invalid_argument("--resume: the results in " + batch.output +
                                " are answers to another request, see " + path);
  }
  // First, since what is older than it is done again, of whichever input it is.
  if (!goes_on) Replace(path, asked);
  SaveInput(batch);
}

std::size_t LeaveOutDone(const Batch& batch, std::vector<FrameFiles>* frames) {
  if (!batch.resume || batch.output.empty()) return 0;
  return std::erase_if(*frames, [&](const FrameFiles& files) { return IsDone(files, batch); });
}

}  // namespace fovea::cli
