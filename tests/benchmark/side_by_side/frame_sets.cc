#include "tests/benchmark/side_by_side/frame_sets.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "tests/evaluation/real_frames/boxed_frames.h"
#include "tests/support/labelled_frame.h"
#include "tests/support/random_scene.h"

namespace fovea::benchmark {
namespace {

using std::filesystem::path;

constexpr CameraIntrinsics kKinect{525, 525, 319.5, 239.5};
const std::vector<cv::Size> kSizes{{320, 240}, {640, 480}, {1280, 720}, {1920, 1080}};

std::string TextOf(const cv::Size& size) { return fmt::format("{}x{}", size.width, size.height); }

template <typename Number = int>
BenchFrame FrameOf(const std::string& name, const RgbdFrame& frame, Number num_objects = 0) {
  return {{name, frame, {}, {}}, static_cast<std::size_t>(num_objects)};
}

// Every so many, from the first on.
template <typename Item>
std::vector<Item> Thinned(const std::vector<Item>& items, std::size_t most) {
  std::vector<Item> chosen;
  const std::size_t count = std::min(most, items.size());
  for (std::size_t i = 0; i < count; ++i) chosen.push_back(items[i * items.size() / count]);
  return chosen;
}

FrameSet Recorded(const std::string& name, const path& folder, std::size_t max_frames) {
  FrameSet set{name, "recorded, " + folder.filename().string(), {}};
  for (const std::string& scene : Thinned(evaluation::SceneNames(folder), max_frames)) {
    const evaluation::Scene loaded =
        evaluation::LoadScene(folder, scene, evaluation::LabelEncoding::kMosd, kKinect);
    double most = 0;
    cv::minMaxLoc(loaded.truth, nullptr, &most);
    set.frames.push_back(FrameOf(scene, loaded.frame, most));
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
        FrameOf(frame.source + "/" + frame.name, frame.frame, required));
  }
  for (const auto& [size, frames] : by_size) {
    sets.push_back({"real " + size, "recorded by others, real/*", Thinned(frames, max_frames)});
  }
}

BenchFrame Generated(const std::string& kind, std::uint64_t seed, const cv::Size& size) {
  const scenes::LabelledFrame made =
      scenes::MakeFrame(scenes::RandomScene(kind, seed, size), scenes::SensorKind::kKinect, seed);
  return FrameOf(fmt::format("{}_{}", kind, seed), made.frame, made.objects.size());
}

// Of as many scenes of these kinds in turn.
FrameSet Generated(const std::string& name, const std::vector<std::string>& kinds,
                   std::uint64_t first_seed, const cv::Size& size, std::size_t count) {
  FrameSet set{name, fmt::format("generated, {} {}", fmt::join(kinds, " and "), TextOf(size)), {}};
  for (std::size_t i = 0; i < count; ++i) {
    set.frames.push_back(Generated(kinds[i % kinds.size()], first_seed + i, size));
  }
  return set;
}

void AddGenerated(const std::string& only, std::size_t count, std::vector<FrameSet>& sets) {
  const auto add = [&](const std::string& name, const std::vector<std::string>& kinds,
                       std::uint64_t first_seed, const cv::Size& size) {
    if (name.starts_with(only)) sets.push_back(Generated(name, kinds, first_seed, size, count));
  };
  for (const cv::Size& size : kSizes) {
    add("tables " + TextOf(size), {"tabletop", "cluttered"}, 1, size);
  }
  const cv::Size usual(640, 480);
  add("1 to 3 objects", {"tablet"}, 101, usual);
  add("3 to 6 objects", {"tabletop"}, 101, usual);
  add("9 to 13 objects", {"cluttered"}, 101, usual);
  add("24 to 30 objects", {"crowded"}, 101, usual);
}

RgbdFrame EmptyFrame() {
  const cv::Size size(640, 480);
  return {cv::Mat(size, CV_8UC3), cv::Mat(size, CV_32FC1), kKinect, std::nullopt};
}

RgbdFrame Noise() {
  RgbdFrame noise = EmptyFrame();
  cv::RNG random(1);
  random.fill(noise.color_rgb, cv::RNG::UNIFORM, 0, 256);
  random.fill(noise.depth_m, cv::RNG::UNIFORM, 0.3, 4);
  return noise;
}

RgbdFrame Checkerboard() {
  RgbdFrame board = EmptyFrame();
  for (int y = 0; y < board.depth_m.rows; ++y) {
    for (int x = 0; x < board.depth_m.cols; ++x) {
      const bool odd = (x / 8 + y / 8) % 2 != 0;
      board.color_rgb.at<cv::Vec3b>(y, x) = cv::Vec3b::all(odd ? 255 : 0);
      board.depth_m.at<float>(y, x) = odd ? 1.0F : 1.1F;
    }
  }
  return board;
}

}  // namespace

std::vector<FrameSet> FrameSets(const std::optional<path>& data, const std::string& only,
                                std::size_t max_frames) {
  constexpr std::size_t kMaxGenerated = 4;  // scenes of a kind are much alike
  std::vector<FrameSet> sets;
  const auto has = [&](const char* name) { return data && exists(*data / name); };
  if (has("osd")) sets.push_back(Recorded("mOSD 640x480", *data / "osd", max_frames));
  if (has("osd_whole"))
    sets.push_back(Recorded("mOSD rooms 640x480", *data / "osd_whole", max_frames));
  if (has("real")) AddReal(*data / "real", max_frames, sets);
  AddGenerated(only, std::min(max_frames, kMaxGenerated), sets);
  sets.push_back({"noise", "generated, 640x480", {FrameOf("noise", Noise())}});
  sets.push_back({"checkerboard", "generated, 640x480", {FrameOf("checkerboard", Checkerboard())}});
  std::erase_if(sets, [&](const FrameSet& set) { return !set.name.starts_with(only); });
  if (sets.empty()) {
    throw std::invalid_argument(fmt::format("--only {}: no set of frames begins so", only));
  }
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
