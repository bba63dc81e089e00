#include "tests/benchmark/side_by_side/frame_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <opencv2/core.hpp>
#include <utility>

#include "tests/evaluation/dataset.h"
#include "tests/evaluation/real_frames/boxed_frames.h"
#include "tests/support/labelled_frame.h"
#include "tests/support/random_scene.h"

namespace fovea::benchmark {
namespace {

using std::filesystem::path;

constexpr CameraIntrinsics kKinect{525, 525, 319.5, 239.5};
const std::vector<cv::Size> kSizes{{320, 240}, {640, 480}, {1280, 720}, {1920, 1080}};

std::string TextOf(const cv::Size& size) { return fmt::format("{}x{}", size.width, size.height); }

// Every so many, from the first on.
template <typename Item>
std::vector<Item> Spread(const std::vector<Item>& items, std::size_t most) {
  std::vector<Item> chosen;
  const std::size_t count = std::min(most, items.size());
  for (std::size_t i = 0; i < count; ++i) chosen.push_back(items[i * items.size() / count]);
  return chosen;
}

FrameSet Recorded(const std::string& name, const path& folder, std::size_t max_frames) {
  FrameSet set{name, "recorded, " + folder.filename().string(), {}};
  for (const std::string& scene : Spread(evaluation::SceneNames(folder), max_frames)) {
    const evaluation::Scene loaded =
        evaluation::LoadScene(folder, scene, evaluation::LabelEncoding::kMosd, kKinect);
    double most = 0;
    cv::minMaxLoc(loaded.truth, nullptr, &most);
    set.frames.push_back({scene, loaded.frame, static_cast<std::size_t>(most)});
  }
  return set;
}

// Frames of other people's cameras, by size.
void AddReal(const path& folder, std::size_t max_frames, std::vector<FrameSet>& sets) {
  std::map<std::string, std::vector<BenchFrame>> by_size;
  for (const evaluation::BoxedFrame& frame : evaluation::LoadBoxedFrames(folder)) {
    const auto required = std::count_if(frame.objects.begin(), frame.objects.end(),
                                        [](const auto& object) { return !object.optional; });
    by_size[TextOf(frame.frame.depth_m.size())].push_back(
        {frame.source + "/" + frame.name, frame.frame, static_cast<std::size_t>(required)});
  }
  for (const auto& [size, frames] : by_size) {
    sets.push_back({"real " + size, "recorded by others, real/*", Spread(frames, max_frames)});
  }
}

BenchFrame Generated(const std::string& kind, std::uint64_t seed, const cv::Size& size) {
  const scenes::LabelledFrame made =
      scenes::MakeFrame(scenes::RandomScene(kind, seed, size), scenes::SensorKind::kKinect, seed);
  return {fmt::format("{}_{}", kind, seed), made.frame, made.objects.size()};
}

void AddGenerated(std::size_t max_frames, std::vector<FrameSet>& sets) {
  for (const cv::Size& size : kSizes) {
    FrameSet set{"tables " + TextOf(size), "generated, seeds from 1 on", {}};
    for (std::size_t i = 0; i < std::min<std::size_t>(max_frames, 4); ++i) {
      set.frames.push_back(Generated(i % 2 == 0 ? "tabletop" : "cluttered", i + 1, size));
    }
    sets.push_back(set);
  }
  const std::vector<std::pair<const char*, const char*>> by_number = {
      {"1 to 3 objects", "tablet"},
      {"3 to 6 objects", "tabletop"},
      {"9 to 13 objects", "cluttered"},
      {"24 to 30 objects", "crowded"}};
  for (const auto& [name, kind] : by_number) {
    FrameSet set{name, fmt::format("generated, {} 640x480", kind), {}};
    for (std::uint64_t seed = 1; seed <= std::min<std::size_t>(max_frames, 4); ++seed) {
      set.frames.push_back(Generated(kind, 100 + seed, {640, 480}));
    }
    sets.push_back(set);
  }
}

FrameSet Hostile() {
  const cv::Size size(640, 480);
  cv::RNG random(1);
  RgbdFrame noise{cv::Mat(size, CV_8UC3), cv::Mat(size, CV_32FC1), kKinect, std::nullopt};
  random.fill(noise.color_rgb, cv::RNG::UNIFORM, 0, 256);
  random.fill(noise.depth_m, cv::RNG::UNIFORM, 0.3, 4);
  RgbdFrame board{cv::Mat(size, CV_8UC3), cv::Mat(size, CV_32FC1), kKinect, std::nullopt};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const bool odd = (x / 8 + y / 8) % 2 != 0;
      board.color_rgb.at<cv::Vec3b>(y, x) = cv::Vec3b::all(odd ? 255 : 0);
      board.depth_m.at<float>(y, x) = odd ? 1.0F : 1.1F;
    }
  }
  return {"noise, checkerboard", "generated, 640x480", {{"noise", noise}, {"checkerboard", board}}};
}

}  // namespace

std::vector<FrameSet> FrameSets(const std::optional<path>& data, std::size_t max_frames) {
  std::vector<FrameSet> sets;
  const auto has = [&](const char* name) { return data && exists(*data / name); };
  if (has("osd")) sets.push_back(Recorded("mOSD 640x480", *data / "osd", max_frames));
  if (has("osd_whole"))
    sets.push_back(Recorded("mOSD rooms 640x480", *data / "osd_whole", max_frames));
  if (has("real")) AddReal(*data / "real", max_frames, sets);
  AddGenerated(max_frames, sets);
  sets.push_back(Hostile());
  return sets;
}

std::vector<std::string> MissingSets(const std::optional<path>& data) {
  std::vector<std::string> missing;
  for (const char* name : {"osd", "osd_whole", "real"}) {
    if (!data || !exists(*data / name)) missing.emplace_back(name);
  }
  return missing;
}

}  // namespace fovea::benchmark
