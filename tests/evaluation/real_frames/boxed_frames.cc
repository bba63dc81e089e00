#include "tests/evaluation/real_frames/boxed_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <map>
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

// x0, y0, x1, y1 of pixels of the image, of which there are some.
cv::Rect ToBox(const nlohmann::json& json, const cv::Size& image, const std::string& place) {
  const bool is_whole =
      json.is_array() && json.size() == 4 &&
      std::all_of(json.begin(), json.end(), [](const auto& n) { return n.is_number_integer(); });
  if (is_whole) {
    const auto c = json.get<std::array<std::int64_t, 4>>();
    if (0 <= c[0] && c[0] < c[2] && c[2] <= image.width && 0 <= c[1] && c[1] < c[3] &&
        c[3] <= image.height) {
      return cv::Rect(static_cast<int>(c[0]), static_cast<int>(c[1]), static_cast<int>(c[2] - c[0]),
                      static_cast<int>(c[3] - c[1]));
    }
  }
  throw std::runtime_error(fmt::format(
      "{}: box {}: expected [x0, y0, x1, y1] with 0 <= x0 < x1 <= {} and 0 <= y0 < y1 <= {}", place,
      json.dump(), image.width, image.height));
}

BoxedObject ToObject(const nlohmann::json& json, const cv::Size& image, const std::string& place) {
  return {json.at("name").get<std::string>(), ToBox(json.at("box"), image, place),
          json.value("small", false)};
}

// A frame's name → its objects.
std::map<std::string, std::vector<nlohmann::json>> ReadBoxes(const fs::path& path) {
  std::ifstream in(path);
  auto boxes = nlohmann::json::parse(in).get<std::map<std::string, std::vector<nlohmann::json>>>();
  if (boxes.empty()) throw std::runtime_error(path.string() + ": no frames here");
  return boxes;
}

void AddSource(const fs::path& folder, std::vector<BoxedFrame>& frames) {
  const fs::path boxes = folder / "boxes.json";
  const CameraIntrinsics intrinsics = ReadIntrinsics(folder / "intrinsics.txt");
  try {
    for (const auto& [name, objects] : ReadBoxes(boxes)) {
      const fs::path png = folder / (name + "_color.png");
      const fs::path color = fs::exists(png) ? png : folder / (name + "_color.jpg");
      frames.push_back({folder.filename().string(),
                        name,
                        LoadFrame(color, folder / (name + "_depth.png"), intrinsics),
                        {}});
      for (const nlohmann::json& object : objects) {
        frames.back().objects.push_back(
            ToObject(object, frames.back().frame.color_rgb.size(), boxes.string() + ": " + name));
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
