#include "tests/evaluation/rgbd_scenes/scenario.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "core/detector.h"
#include "tests/evaluation/box_matching.h"
#include "tests/evaluation/dataset.h"

namespace fovea::evaluation {
namespace {

namespace fs = std::filesystem;

RgbdFrame ReadFrame(const fs::path& color, const CameraIntrinsics& intrinsics) {
  fs::path depth = color;
  depth.replace_filename(color.stem().string() + "_depth.png");
  return LoadFrame(color, depth, intrinsics);
}

template <typename Objects, typename BoxOf>
std::vector<cv::Rect> BoxesOf(const Objects& objects, BoxOf box_of) {
  std::vector<cv::Rect> boxes;
  boxes.reserve(objects.size());
  for (const auto& object : objects) boxes.push_back(box_of(object));
  return boxes;
}

}  // namespace

std::vector<Scenario> FindScenarios(const fs::path& data) {
  std::vector<Scenario> scenarios;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(data)) {
    const fs::path& file = entry.path();
    const fs::path folder = file.parent_path() / file.stem();
    if (file.extension() != ".mat" || !fs::is_directory(folder)) continue;
    scenarios.push_back({file.stem().string(), folder, ReadAnnotations(file)});
  }
  if (scenarios.empty()) {
    throw std::runtime_error(data.string() + ": no NAME.mat beside a folder NAME here");
  }
  std::sort(scenarios.begin(), scenarios.end(),
            [](const Scenario& a, const Scenario& b) { return a.name < b.name; });
  return scenarios;
}

DetectionRate RateOf(const Scenario& scenario, const CameraIntrinsics& intrinsics,
                     const DetectorOptions& options, const std::function<void()>& done) {
  DetectionRate rate;
  int num_frames = 0;
  for (std::size_t i = 0; i < scenario.objects.size(); ++i) {
    const fs::path color = scenario.folder / (scenario.name + "_" + std::to_string(i + 1) + ".png");
    if (!fs::exists(color)) continue;
    ++num_frames;
    const std::vector<DetectedObject> found = Detect(ReadFrame(color, intrinsics), options).objects;
    const std::vector<int> matched =
        MatchBoxes(BoxesOf(scenario.objects[i], [](const auto& object) { return object.box; }),
                   BoxesOf(found, [](const auto& object) { return object.bounds_px; }));
    rate.objects += static_cast<int>(matched.size());
    rate.detected += static_cast<int>(
        std::count_if(matched.begin(), matched.end(), [](int index) { return index >= 0; }));
    if (done) done();
  }
  if (num_frames == 0) throw std::runtime_error(scenario.folder.string() + ": no frames here");
  return rate;
}

PublishedRate PublishedRateOf(const std::string& scenario) {
  static const std::map<std::string, PublishedRate> rates = {
      {"desk_1", {185, 96.8}},          {"desk_2", {352, 82.1}},           {"desk_3", {584, 92.6}},
      {"kitchen_small_1", {639, 87.5}}, {"meeting_small_1", {1582, 74.5}}, {"table_1", {740, 89.2}},
      {"table_small_1", {733, 92.4}},   {"table_small_2", {677, 98.5}}};
  const auto found = rates.find(scenario);
  return found == rates.end() ? PublishedRate() : found->second;
}

}  // namespace fovea::evaluation
