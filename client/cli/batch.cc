#include "client/cli/batch.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "client/cli/output_check.h"
#include "client/cli/outputs.h"
#include "client/cli/progress.h"
#include "client/cli/report.h"

namespace fovea::cli {
namespace {

namespace fs = std::filesystem;

// The frame's name where the file is a colour image, else empty.
std::string FrameName(const std::string& filename) {
  for (const std::string ending : {"_color.png", "_color.jpg", "_color.jpeg"}) {
    if (filename.size() > ending.size() && filename.ends_with(ending)) {
      return filename.substr(0, filename.size() - ending.size());
    }
  }
  return {};
}

// Sorted by name; a depth path is there whether the file is or not.
std::vector<FrameFiles> ListFrames(const fs::path& input) {
  std::error_code error;
  fs::directory_iterator entries(input, error);
  if (error) throw std::runtime_error("cannot read " + input.string() + ": " + error.message());
  std::vector<FrameFiles> frames;
  for (const fs::directory_entry& entry : entries) {
    const std::string name = FrameName(entry.path().filename().string());
    if (name.empty()) continue;
    frames.push_back({name, entry.path().string(), (input / (name + "_depth.png")).string()});
  }
  std::sort(frames.begin(), frames.end(), [](const FrameFiles& a, const FrameFiles& b) {
    return std::tie(a.id, a.color_path) < std::tie(b.id, b.color_path);
  });
  return frames;
}

OutputPaths OutputsOf(const std::string& name, const fs::path& output) {
  return {.labels = (output / (name + ".png")).string(),
          .json = (output / (name + ".json")).string(),
          .overlay = (output / (name + "_overlay.png")).string(),
          .cloud = {},
          .saliency_prefix = {},
          .steps = {}};
}

v1::Detections DetectFrame(const client::Client& client, const FrameFiles& files,
                           const OutputPaths& outputs, const FrameSettings& settings,
                           std::chrono::milliseconds timeout) {
  if (!fs::exists(files.depth_path)) throw std::runtime_error("no " + files.depth_path);
  const v1::DetectRequest request = MakeRequest(files, settings);
  v1::DetectResponse response = client.Detect(request, timeout);
  WriteOutputs(outputs, files, settings, request, response.detections());
  return std::move(*response.mutable_detections());
}

std::vector<std::string> NotesOf(const v1::Detections& found) {
  if (!found.objects().empty() && found.has_support_surface()) return {};
  const auto& messages = found.diagnostics().messages();
  return {messages.begin(), messages.end()};
}

}  // namespace

bool DetectFolder(const client::Client& client, const std::string& input, const std::string& output,
                  FrameSettings settings, std::chrono::milliseconds timeout,
                  const std::function<std::string(const client::RpcError&)>& explain) {
  const std::vector<FrameFiles> frames = ListFrames(input);
  if (frames.empty()) {
    throw std::runtime_error("no NAME_color.png, .jpg or .jpeg with NAME_depth.png in " + input);
  }
  PrepareFolder(input, output);
  RequestFor(OutputsOf("any", output), &settings.options);

  Progress progress(frames.size());
  std::size_t num_failed = 0;
  int num_objects = 0;
  const auto fail = [&](const std::string& id, const std::string& why) {
    ++num_failed;
    progress.Complain("fovea: " + id + ": " + why);
    progress.Advance(id + ": failed");
  };
  for (const FrameFiles& files : frames) {
    try {
      const v1::Detections found =
          DetectFrame(client, files, OutputsOf(files.id, output), settings, timeout);
      num_objects += found.objects_size();
      progress.Advance(files.id + ": " + NumObjects(found.objects_size()), NotesOf(found));
    } catch (const client::RpcError& error) {
      fail(files.id, explain(error));
    } catch (const std::exception& error) {
      fail(files.id, error.what());
    }
  }
  progress.Finish();
  std::cout << frames.size() - num_failed << " of " << frames.size() << " frames done, "
            << NumObjects(num_objects) << ", " << num_failed << " failed\n";
  return num_failed == 0;
}

}  // namespace fovea::cli
