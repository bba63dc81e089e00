#include "tests/evaluation/real_frames/boxed_frames.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/evaluation/dataset.h"

namespace fovea::evaluation {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> SourcesIn(const fs::path& folder) {
  if (fs::exists(folder / "boxes.json")) return {folder};
  std::vector<fs::path> sources;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (fs::exists(entry.path() / "boxes.json")) sources.push_back(entry.path());
  }
  std::sort(sources.begin(), sources.end());
  if (sources.empty()) throw std::runtime_error(folder.string() + ": no boxes.json here");
  return sources;
}

CameraIntrinsics ReadIntrinsics(const fs::path& path) {
  std::ifstream in(path);
  CameraIntrinsics k;
  char comma = 0;
  if (!(in >> k.fx_px >> comma >> k.fy_px >> comma >> k.cx_px >> comma >> k.cy_px)) {
    throw std::runtime_error(path.string() + ": expected fx,fy,cx,cy");
  }
  return k;
}

BoxedObject ToObject(const nlohmann::json& json) {
  const auto corners = json.at("box").get<std::array<int, 4>>();
  return {json.at("name").get<std::string>(),
          {cv::Point(corners[0], corners[1]), cv::Point(corners[2], corners[3])},
          json.value("small", false)};
}

void AddSource(const fs::path& folder, std::vector<BoxedFrame>& frames) {
  const fs::path boxes = folder / "boxes.json";
  const CameraIntrinsics intrinsics = ReadIntrinsics(folder / "intrinsics.txt");
  try {
    std::ifstream in(boxes);
    const nlohmann::json json = nlohmann::json::parse(in);
    for (const auto& [name, objects] : json.items()) {
      const fs::path png = folder / (name + "_color.png");
      const fs::path color = fs::exists(png) ? png : folder / (name + "_color.jpg");
      frames.push_back({folder.filename().string(),
                        name,
                        LoadFrame(color, folder / (name + "_depth.png"), intrinsics),
                        {}});
      for (const nlohmann::json& object : objects) {
        frames.back().objects.push_back(ToObject(object));
      }
    }
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(boxes.string() + ": " + error.what());
  }
}

}  // namespace

std::vector<BoxedFrame> LoadBoxedFrames(const fs::path& folder) {
  std::vector<BoxedFrame> frames;
  // A path that ends with a slash has no name.
  const fs::path normal = (fs::absolute(folder) / ".").lexically_normal().parent_path();
  for (const fs::path& source : SourcesIn(normal)) AddSource(source, frames);
  return frames;
}

}  // namespace fovea::evaluation
