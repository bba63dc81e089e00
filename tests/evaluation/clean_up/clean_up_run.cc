#include "tests/evaluation/clean_up/clean_up_run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "tests/e2e/process.h"
#include "tests/evaluation/clean_up/client_dialog.h"
#include "tests/evaluation/generated/generated_flags.h"
#include "tests/evaluation/grasp_figures/grasp_overlay.h"
#include "tests/evaluation/output.h"
#include "tests/evaluation/parallel.h"
#include "tests/support/scene_files.h"

namespace fovea::evaluation {
namespace {

constexpr std::size_t kAttemptsPerThing = 4;

// The robot's hands: two fingers that open 140 mm, and a cup of 30 mm. It can try again, so that
// unlikely grasps are welcome.
std::vector<Gripper> Hands() {
  JawGripper jaw;
  jaw.max_opening_m = 0.14F;
  Gripper fingers, cup;
  fingers.name = "jaw";
  fingers.hand = jaw;
  cup.name = "cup";
  cup.hand = SuctionGripper{};
  cup.max_tilt_rad = 0.8F;
  for (Gripper* hand : {&fingers, &cup}) {
    hand->max_grasps = 20;
    hand->min_probability = 0.01F;
  }
  return {fingers, cup};
}

// The reason for the thing found whose box is most like this one.
std::string ReasonFor(const cv::Rect& bounds, const std::vector<FoundThing>& found) {
  constexpr double kSame = 0.4;
  double best = kSame;
  std::string reason;
  for (const FoundThing& thing : found) {
    const double shared = (thing.bounds_px & bounds).area();
    const double iou = shared / std::max(1.0, thing.bounds_px.area() + bounds.area() - shared);
    if (iou <= best) continue;
    best = iou;
    reason = thing.reason;
  }
  return reason;
}

std::vector<LeftThing> WhatIsLeft(const FloorWorld& world, const scenes::LabelledFrame& frame,
                                  const std::vector<FoundThing>& found) {
  std::vector<LeftThing> left;
  for (const scenes::ObjectTruth& thing : frame.objects) {
    const cv::Rect bounds = cv::boundingRect(frame.labels == thing.label);
    left.push_back({thing.name, ReasonFor(bounds, found), world.CanBeTaken(thing.label),
                    world.CarriesAnother(thing.label)});
  }
  return left;
}

void WritePicture(const CleanUpFlags& flags, const CleanedScene& scene,
                  const scenes::LabelledFrame& frame, const std::vector<Gripper>& hands,
                  const Attempt* attempt) {
  if (flags.pictures.empty()) return;
  std::vector<EndedGrasp> drawn;
  if (attempt != nullptr) drawn.push_back({attempt->grasp, attempt->outcome});
  const Gripper& hand = hands[attempt != nullptr ? attempt->grasp.gripper : 0];
  const std::size_t step = scene.attempts.size() + (attempt == nullptr ? 1 : 0);
  const std::string name = fmt::format("scene_{:02}_step_{:02}.jpg", scene.seed, step);
  scenes::WriteImage(std::filesystem::path(flags.pictures) / name,
                     DrawGrasps(frame.frame, hand, drawn));
}

void CleanUpOne(const CleanUpFlags& flags, CleanedScene& result) {
  const std::uint64_t seed = result.seed;
  FloorWorld world(ClutteredFloor(seed, flags.num_things), Hands(), SensorOf(flags.sensor), seed);
  result.num_things = world.NumThings();
  testing::Process program(flags.program, STDERR_FILENO);
  while (true) {
    const scenes::LabelledFrame frame = world.Look();
    const std::string id = fmt::format("{}/{}", seed, result.attempts.size());
    const bool heard = program.WriteLine(RequestLine(frame, world.hands(), id));
    const std::string line = heard ? program.ReadLine() : "";
    if (line.empty()) throw std::runtime_error(flags.program.front() + " ended before its time");
    const Decision decision = DecisionOf(line);
    if (const auto* found = std::get_if<std::vector<FoundThing>>(&decision)) {
      WritePicture(flags, result, frame, world.hands(), nullptr);
      result.left = WhatIsLeft(world, frame, *found);
      return;
    }
    result.attempts.push_back(world.Take(std::get<Grasp>(decision)));
    WritePicture(flags, result, frame, world.hands(), &result.attempts.back());
    if (result.attempts.size() < kAttemptsPerThing * result.num_things) continue;
    result.gave_up = world.NumThings() > 0;
    result.left = WhatIsLeft(world, world.Look(), {});
    return;
  }
}

}  // namespace

std::vector<CleanedScene> CleanUp(const CleanUpFlags& flags, const SceneEnded& on_end) {
  if (!flags.pictures.empty()) std::filesystem::create_directories(flags.pictures);
  const auto count = static_cast<std::size_t>(flags.num_scenes);
  std::vector<CleanedScene> scenes(count);
  std::mutex mutex;  // guards what follows
  std::vector<char> has_ended(count, 0);
  std::size_t done = 0, told = 0;
  ForEachIndex(count, flags.num_threads, [&](std::size_t i) {
    scenes[i].seed = flags.first_seed + i;
    try {
      CleanUpOne(flags, scenes[i]);
    } catch (const std::exception& error) {
      scenes[i].error = error.what();
    }
    const std::scoped_lock lock(mutex);
    has_ended[i] = 1;
    ShowProgress("scenes", ++done, count);
    for (; told < count && has_ended[told] != 0; ++told) on_end(scenes[told]);
  });
  return scenes;
}

}  // namespace fovea::evaluation
