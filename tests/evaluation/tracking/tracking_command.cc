#include "tests/evaluation/tracking/tracking_command.h"

#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>

#include "tests/evaluation/generated/generated_flags.h"
#include "tests/evaluation/output.h"
#include "tests/evaluation/parallel.h"
#include "tests/evaluation/tracking/stream_run.h"
#include "tests/evaluation/tracking/tracking_report.h"
#include "tests/support/random_scene.h"
#include "tests/support/sensor_names.h"

namespace fovea::evaluation {
namespace {

struct TrackingFlags {
  std::vector<std::string> motions = StreamMotions();
  std::vector<std::string> kinds = {"tabletop", "cluttered", "stacked",  "touching",
                                    "occluded", "household", "supplies", "floor"};
  std::vector<std::string> sensors = {"kinect", "realsense"};
  std::string profile = "default";
  int num_streams = 8;
  std::uint64_t first_seed = 9000;
  bool true_masks = false, list_switches = false;
  int num_threads = 1;
  std::string json;
};

// Kinds and sensors in turn, so that a few streams have some of all.
std::vector<StreamSpec> SpecsOf(const TrackingFlags& flags, const std::string& motion) {
  std::vector<StreamSpec> specs;
  for (int i = 0; i < flags.num_streams; ++i) {
    const std::string& kind = flags.kinds[i % flags.kinds.size()];
    const std::string& sensor = flags.sensors[(i + i / flags.kinds.size()) % flags.sensors.size()];
    specs.push_back(
        {motion, kind, flags.first_seed + static_cast<std::uint64_t>(i), SensorOf(sensor)});
  }
  return specs;
}

void Run(const TrackingFlags& flags) {
  const DetectorOptions options = OptionsOfProfile(flags.profile);
  const Masks masks = flags.true_masks ? Masks::kTrue : Masks::kDetected;
  nlohmann::json rows = nlohmann::json::array();
  PrintTrackingHeader();
  for (const std::string& motion : flags.motions) {
    const std::vector<StreamSpec> specs = SpecsOf(flags, motion);
    std::vector<std::array<TrackedStream, 2>> streams(specs.size());
    std::mutex mutex;  // guards done
    std::size_t done = 0;
    ForEachIndex(specs.size(), flags.num_threads, [&](std::size_t i) {
      streams[i] = TrackStream(specs[i], options, masks);
      const std::scoped_lock lock(mutex);
      ShowProgress(motion, ++done, specs.size());
    });
    rows.push_back(ReportTracking(specs, streams, Poses::kGiven, flags.list_switches));
    rows.push_back(ReportTracking(specs, streams, Poses::kNone, flags.list_switches));
  }
  WriteJson(flags.json, rows);
}

}  // namespace

void AddTrackingCommand(CLI::App& app) {
  auto flags = std::make_shared<TrackingFlags>();
  CLI::App* command = app.add_subcommand(
      "tracking",
      "Identities in generated streams of ten frames a second, with the camera's poses and "
      "without: HOTA, AssA (most: with these masks if identities were known; AssAfnd: of the "
      "frames in which a thing was found), IDF1, switches per 100 object frames, share of frames "
      "that keep an identity, identities after a cover");
  command->add_option("--motions", flags->motions, "still, circle, shake, moved, covered")
      ->delimiter(',')
      ->check(CLI::IsMember(StreamMotions()));
  command->add_option("--kinds", flags->kinds, "Kinds of scenes, in turn")
      ->delimiter(',')
      ->check(CLI::IsMember(scenes::SceneKinds()))
      ->capture_default_str();
  command->add_option("--sensors", flags->sensors, "Their sensors, in turn")
      ->delimiter(',')
      ->check(CLI::IsMember(scenes::SensorsByName()))
      ->capture_default_str();
  command->add_option("--streams", flags->num_streams, "Of each motion")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command->add_option("--seed", flags->first_seed, "Of the first one; the others count on")
      ->capture_default_str();
  command->add_option("--profile", flags->profile, "Of the detector")
      ->check(CLI::IsMember(ProfileNames()))
      ->capture_default_str();
  command->add_flag("--true-masks", flags->true_masks,
                    "Track the true masks instead of what the detector finds");
  command->add_flag("--list", flags->list_switches, "Print a line per switch");
  command->add_option("--threads", flags->num_threads, "Streams at a time")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  command->add_option("--json", flags->json, "Write the figures to this file")
      ->check(WhyNotWritable);
  command->callback([flags] { Run(*flags); });
}

}  // namespace fovea::evaluation
