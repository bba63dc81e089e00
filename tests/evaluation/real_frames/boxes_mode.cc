#include "tests/evaluation/real_frames/boxes_mode.h"

#include <fmt/format.h>

#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/detector.h"
#include "tests/evaluation/camera_effects.h"
#include "tests/evaluation/output.h"
#include "tests/evaluation/peers/peer.h"
#include "tests/evaluation/real_frames/boxed_run.h"
#include "tests/evaluation/reliability_report.h"
#include "tests/support/scene_files.h"

namespace fovea::evaluation {
namespace {

void RefuseOtherModes(const DetectionFlags& flags) {
  const auto refuse = [](bool given, const std::string& flag) {
    if (given) throw std::invalid_argument(flag + " needs label images, not boxes");
  };
  refuse(!flags.sweeps.empty(), "--sweep");
  refuse(flags.true_seeds, "--true-seeds");
  const DetectionFlags unset;
  refuse(flags.intrinsics != unset.intrinsics, "--intrinsics");
  refuse(flags.num_repeats != unset.num_repeats, "--repeat");
  refuse(flags.num_folds != unset.num_folds, "--folds");
  refuse(!flags.plot.empty() && !flags.methods.empty(), "--plot of --methods");
  refuse(!flags.plot.empty() && flags.with_effects, "--plot of --camera-effects");
}

DetectInFrame Detector(const DetectionFlags& flags, const std::string& method) {
  if (IsPeer(method)) {
    return [method](const RgbdFrame& frame) {
      Detections detections;
      detections.labels = SegmentWithPeer(method, frame);
      return detections;
    };
  }
  return [options = OptionsOf(flags, method)](const RgbdFrame& frame) {
    return Detect(frame, options);
  };
}

std::vector<BoxedFrameResult> Run(const DetectionFlags& flags,
                                  const std::vector<BoxedFrame>& frames, const std::string& method,
                                  const std::string& row) {
  std::size_t count = 0;
  const auto done = [&](const BoxedFrame& frame, const Detections& detections) {
    ShowProgress("detecting", ++count, frames.size());
    if (flags.overlays.empty()) return;
    scenes::WriteImage(OverlayPath(flags, frame.source + "_" + frame.name, row),
                       DrawBoxes(frame, detections.labels));
  };
  return RunBoxedFrames(frames, Detector(flags, method), flags.num_threads, done);
}

// One group a source, so that what is calibrated is judged on other cameras.
ReliabilityReport ReliabilityBySource(const std::vector<BoxedFrameResult>& results) {
  std::map<std::string, std::vector<Prediction>> groups;
  for (const BoxedFrameResult& result : results) {
    std::vector<Prediction>& group = groups[result.source];
    group.insert(group.end(), result.predictions.begin(), result.predictions.end());
  }
  std::vector<std::vector<Prediction>> list;
  list.reserve(groups.size());
  for (const auto& [source, group] : groups) list.push_back(group);
  return ReportReliability(list);
}

void PrintFrames(const std::vector<BoxedFrameResult>& results) {
  for (const BoxedFrameResult& result : results) {
    const BoxScores& scores = result.scores;
    std::cout << result.source << '/' << result.name << ": " << scores.found << " of "
              << scores.required << " found, " << scores.wrong << " wrong\n";
  }
  std::cout << '\n';
}

// One row per camera effect, after one without.
void RunEffects(const DetectionFlags& flags, const std::vector<BoxedFrame>& frames) {
  nlohmann::json rows = nlohmann::json::array();
  const auto run = [&](const std::string& effect, const std::vector<BoxedFrame>& seen) {
    const BoxSummary summary = Summarize(Run(flags, seen, flags.profile, effect));
    fmt::print("{:<16} F1 {:.1f}, mean of the sources {:.1f}{}\n", effect,
               100 * summary.all.Boxes().f, 100 * summary.mean_f1,
               summary.has_clear
                   ? fmt::format(", clear glass {:.1f}", 100 * summary.clear.Boxes().f)
                   : "");
    rows.push_back({{"effect", effect}, {"summary", ToJson(summary)}});
  };
  run("as recorded", frames);
  for (const CameraEffect& effect : CameraEffects()) {
    std::vector<BoxedFrame> changed = frames;
    for (std::size_t i = 0; i < changed.size(); ++i) {
      changed[i].frame = WithCameraEffect(frames[i].frame, effect.name, i);
    }
    run(effect.name, changed);
  }
  WriteJson(flags.json, rows);
}

}  // namespace

void RunBoxesMode(const DetectionFlags& flags) {
  RefuseOtherModes(flags);
  const std::vector<BoxedFrame> frames = LoadBoxedFrames(flags.data);
  if (flags.with_effects) return RunEffects(flags, frames);
  const std::vector<std::string> methods =
      flags.methods.empty() ? std::vector<std::string>{flags.profile} : flags.methods;
  std::vector<BoxSummary> summaries;
  nlohmann::json rows = nlohmann::json::array();
  for (const std::string& method : methods) {
    const std::vector<BoxedFrameResult> results =
        Run(flags, frames, method, flags.methods.empty() ? "" : method);
    summaries.push_back(Summarize(results));
    if (flags.print_scenes) PrintFrames(results);
    PrintBoxSummary(std::cout, method, summaries.back());
    nlohmann::json row = {
        {"method", method}, {"summary", ToJson(summaries.back())}, {"frames", ToJson(results)}};
    if (!IsPeer(method)) {
      const ReliabilityReport reliability = ReliabilityBySource(results);
      PrintReliability(std::cout, reliability);
      row["reliability"] = ToJson(reliability);
      if (flags.methods.empty()) WriteText(flags.plot, DrawSvg({ReliabilityChart(reliability)}));
    }
    rows.push_back(std::move(row));
  }
  if (methods.size() > 1) PrintSideBySide(std::cout, methods, summaries);
  WriteJson(flags.json, rows);
}

}  // namespace fovea::evaluation
