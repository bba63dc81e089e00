#include "tests/evaluation/detection_modes.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "tests/evaluation/camera_effects.h"
#include "tests/evaluation/detection_run.h"
#include "tests/evaluation/output.h"
#include "tests/evaluation/peers/peer.h"
#include "tests/evaluation/real_frames/boxes_mode.h"
#include "tests/evaluation/reliability_report.h"
#include "tests/evaluation/report.h"
#include "tests/evaluation/score_charts.h"
#include "tests/evaluation/settings.h"
#include "tests/evaluation/true_seeds.h"
#include "tests/support/scene_files.h"

namespace fovea::evaluation {
namespace {

std::vector<Scene> LoadScenes(const DetectionFlags& flags) {
  const std::vector<double>& k = flags.intrinsics;
  const std::vector<std::string> names = SceneNames(flags.data);
  std::vector<Scene> scenes;
  for (const std::string& name : names) {
    scenes.push_back(LoadScene(flags.data, name, flags.encoding, {k[0], k[1], k[2], k[3]}));
    ShowProgress("reading  ", scenes.size(), names.size());
  }
  return scenes;
}

// `row`: which of several, in the names of pictures.
std::vector<SceneResult> Evaluate(const DetectionFlags& flags, const std::vector<Scene>& scenes,
                                  const DetectFunction& detect, const std::string& row = "") {
  std::size_t done = 0;
  return RunDetection(
      scenes, detect, flags.num_threads,
      [&](const Scene& scene, const Detections& detections) {
        ShowProgress("detecting", ++done, scenes.size());
        if (flags.overlays.empty()) return;
        scenes::WriteImage(OverlayPath(flags, scene.name + "_overlay", row),
                           DrawOverlay(scene, detections.labels));
      },
      flags.num_repeats);
}

DetectFunction OurDetector(const DetectionFlags& flags, const DetectorOptions& options) {
  return flags.true_seeds ? DetectFromTrueSeeds(options) : DetectWith(options);
}

void RunOnce(const DetectionFlags& flags, const std::vector<Scene>& scenes,
             const DetectorOptions& options) {
  const std::vector<SceneResult> results = Evaluate(flags, scenes, OurDetector(flags, options));
  const Summary summary = Summarize(results, flags.num_folds);
  if (flags.print_scenes) PrintScenes(std::cout, results);
  PrintSummaryHeader(std::cout);
  PrintSummaryRow(std::cout, std::to_string(results.size()) + " scenes", summary);
  PrintMeanOverImages(std::cout, summary);
  PrintStages(std::cout, summary);
  const ReliabilityReport reliability =
      ReportReliability(PredictionsOfFolds(results, flags.num_folds));
  PrintReliability(std::cout, reliability);
  WriteText(flags.plot, DrawSvg({ReliabilityChart(reliability)}));
  WriteJson(flags.json, {{"options", OptionValues(options)},
                         {"summary", ToJson(summary)},
                         {"reliability", ToJson(reliability)},
                         {"scenes", ToJson(results)}});
}

// One row per value; several sweeps run one after the other, each from the same start.
void RunSweeps(const DetectionFlags& flags, const std::vector<Scene>& scenes,
               const DetectorOptions& options) {
  nlohmann::json rows = nlohmann::json::array();
  std::vector<Chart> charts;
  std::vector<std::pair<std::string, std::vector<double>>> sweeps;
  for (const std::string& text : flags.sweeps) sweeps.push_back(ParseSweep(text, options));
  PrintSummaryHeader(std::cout);
  for (const auto& [name, values] : sweeps) {
    std::vector<Summary> summaries;
    for (const double value : values) {
      DetectorOptions changed = options;
      SetOption(changed, name, value);
      std::ostringstream title;
      title << name << '=' << value;
      const Summary summary = Summarize(
          Evaluate(flags, scenes, OurDetector(flags, changed), title.str()), flags.num_folds);
      PrintSummaryRow(std::cout, title.str(), summary);
      rows.push_back({{"name", name}, {"value", value}, {"summary", ToJson(summary)}});
      summaries.push_back(summary);
    }
    charts.push_back(SweepChart(name, values, summaries));
  }
  WriteText(flags.plot, DrawSvg(charts));
  WriteJson(flags.json, rows);
}

void CompareMethods(const DetectionFlags& flags, const std::vector<Scene>& scenes) {
  nlohmann::json rows = nlohmann::json::array();
  std::vector<Summary> summaries;
  PrintSummaryHeader(std::cout);
  for (const std::string& method : flags.methods) {
    const DetectFunction detect =
        IsPeer(method) ? DetectWithPeer(method) : OurDetector(flags, OptionsOf(flags, method));
    const std::vector<SceneResult> results = Evaluate(flags, scenes, detect, method);
    const Summary summary = Summarize(results, flags.num_folds);
    PrintSummaryRow(std::cout, method, summary);
    rows.push_back({{"method", method}, {"summary", ToJson(summary)}, {"scenes", ToJson(results)}});
    summaries.push_back(summary);
  }
  WriteText(flags.plot, DrawSvg({MethodsChart(flags.methods, summaries)}));
  WriteJson(flags.json, rows);
}

// The scenes as another camera would have seen them. Where it sees no depth nobody knows the truth.
std::vector<Scene> WithEffect(const std::vector<Scene>& scenes, const std::string& effect) {
  std::vector<Scene> changed = scenes;
  for (std::size_t i = 0; i < changed.size(); ++i) {
    changed[i].frame = WithCameraEffect(scenes[i].frame, effect, i);
    const cv::Mat& depth_m = changed[i].frame.depth_m;
    changed[i].valid = cv::Mat(scenes[i].valid & (depth_m == depth_m));  // false for NaN
  }
  return changed;
}

// One row per camera effect, after one without.
void RunEffects(const DetectionFlags& flags, const std::vector<Scene>& scenes,
                const DetectorOptions& options) {
  nlohmann::json rows = nlohmann::json::array();
  std::vector<std::string> names;
  std::vector<Summary> summaries;
  const auto run = [&](const std::string& name, const std::vector<Scene>& seen) {
    const Summary summary =
        Summarize(Evaluate(flags, seen, OurDetector(flags, options), name), flags.num_folds);
    PrintSummaryRow(std::cout, name, summary);
    rows.push_back({{"effect", name}, {"summary", ToJson(summary)}});
    names.push_back(name);
    summaries.push_back(summary);
  };
  PrintSummaryHeader(std::cout);
  run("as recorded", scenes);
  for (const CameraEffect& effect : CameraEffects()) {
    run(effect.name, WithEffect(scenes, effect.name));
  }
  WriteText(flags.plot, DrawSvg({MethodsChart(names, summaries)}));
  WriteJson(flags.json, rows);
}

}  // namespace

bool IsPeer(const std::string& method) {
  const std::vector<std::string> peers = PeerNames();
  return std::find(peers.begin(), peers.end(), method) != peers.end();
}

DetectorOptions OptionsOf(const DetectionFlags& flags, const std::string& profile) {
  DetectorOptions options = OptionsOfProfile(profile);
  ApplySettings(options, flags.settings);
  return options;
}

std::string OverlayPath(const DetectionFlags& flags, const std::string& scene,
                        const std::string& row) {
  std::string name = row.empty() ? scene : scene + "_" + row;
  std::replace(name.begin(), name.end(), ' ', '_');
  return flags.overlays + "/" + name + ".png";
}

void RunDetectionMode(const DetectionFlags& flags) {
  const bool has_rows = !flags.methods.empty() || !flags.sweeps.empty() || flags.with_effects;
  const bool has_lines = flags.encoding == LabelEncoding::kBoxes && !flags.with_effects;
  if (flags.print_scenes && has_rows && !has_lines) {
    throw std::invalid_argument("--scenes does not go with several rows of scores");
  }
  if (!flags.overlays.empty()) std::filesystem::create_directories(flags.overlays);
  if (flags.encoding == LabelEncoding::kBoxes) return RunBoxesMode(flags);
  const std::vector<Scene> scenes = LoadScenes(flags);
  if (!flags.methods.empty()) {
    CompareMethods(flags, scenes);
  } else if (!flags.sweeps.empty()) {
    RunSweeps(flags, scenes, OptionsOf(flags, flags.profile));
  } else if (flags.with_effects) {
    RunEffects(flags, scenes, OptionsOf(flags, flags.profile));
  } else {
    RunOnce(flags, scenes, OptionsOf(flags, flags.profile));
  }
}

}  // namespace fovea::evaluation
