#include "tests/evaluation/object_fit/object_model_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "tests/evaluation/object_fit/model_fit.h"
#include "tests/evaluation/object_fit/tree_samples.h"
#include "tests/evaluation/output.h"
#include "tests/evaluation/parallel.h"
#include "tests/evaluation/real_frames/boxed_run.h"
#include "tests/evaluation/settings.h"

namespace fovea::evaluation {
namespace {

// Each scene is seen with voxels of these shares of their size, so that the model hears of pieces
// that might as well have been. More of them, and mirrored scenes, teach no more.
constexpr std::array<double, 3> kVoxelShares = {1, 0.88, 1.13};
constexpr int kMaxIterations = 150;

struct ObjectModelFlags {
  std::vector<std::string> boxes;  // DIR or DIR=WEIGHT
  std::vector<std::string> mosd;
  std::vector<std::string> plain;
  std::vector<double> intrinsics = {525, 525, 319.5, 239.5};
  FitPenalties penalties;
  bool leave_one_out = false;
  int num_threads = 1;
  std::string source;
  std::vector<std::string> settings;  // name=value
};

DetectorOptions OptionsOf(const ObjectModelFlags& flags) {
  DetectorOptions options = OptionsOfProfile("default");
  ApplySettings(options, flags.settings);
  return options;
}

// Samples `count` scenes with each size of voxels, the original first.
template <typename LoadScene>
void Sample(const std::string& what, std::size_t count, double weight,
            const ObjectModelFlags& flags, const LoadScene& load,
            std::vector<TreeSample>& samples) {
  const std::size_t first = samples.size();
  samples.resize(first + count * kVoxelShares.size());
  std::mutex mutex;  // guards done
  std::size_t done = 0;
  ForEachIndex(count, flags.num_threads, [&](std::size_t i) {
    const auto scene = load(i);
    for (std::size_t k = 0; k < kVoxelShares.size(); ++k) {
      DetectorOptions options = OptionsOf(flags);
      options.voxels.size_m *= kVoxelShares[k];
      TreeSample& sample = samples[first + i * kVoxelShares.size() + k];
      sample = SampleOf(scene, options);
      sample.weight = weight / static_cast<double>(kVoxelShares.size());
      sample.is_original = k == 0;
    }
    const std::scoped_lock lock(mutex);
    ShowProgress(what, ++done, count);
  });
}

std::vector<TreeSample> SampleAll(const ObjectModelFlags& flags, std::vector<BoxedFrame>& frames) {
  std::vector<TreeSample> samples;
  const auto add_labelled = [&](const std::string& text, LabelEncoding encoding) {
    const auto [folder, weight] = ParseWeighted(text);
    const std::vector<std::string> names = SceneNames(folder);
    const std::vector<double>& k = flags.intrinsics;
    Sample(
        folder, names.size(), weight, flags,
        [&, &dir = folder](std::size_t i) {
          return LoadScene(dir, names[i], encoding, {k[0], k[1], k[2], k[3]});
        },
        samples);
  };
  for (const std::string& text : flags.mosd) add_labelled(text, LabelEncoding::kMosd);
  for (const std::string& text : flags.plain) add_labelled(text, LabelEncoding::kPlain);
  for (const std::string& text : flags.boxes) {
    const auto [folder, weight] = ParseWeighted(text);
    const std::vector<BoxedFrame> loaded = LoadBoxedFrames(folder);
    Sample(
        folder, loaded.size(), weight, flags, [&](std::size_t i) { return loaded[i]; }, samples);
    frames.insert(frames.end(), loaded.begin(), loaded.end());
  }
  return samples;
}

// What is left out is also detected with voxels of these shares of their size: where their borders
// lie is chance, and moves the F1 of so few frames by several points.
constexpr std::array<double, 9> kScoredShares = {1, 0.88, 0.91, 0.94, 0.97, 1.03, 1.06, 1.09, 1.13};

struct LeftOut {
  std::array<std::vector<BoxedFrameResult>, kScoredShares.size()> results;  // of each share
  double loss = 0;  // summed over the frames, not their variants
};

// The frames of one group of sources by a model that was fitted to everything but it.
LeftOut LeaveOut(const std::string& group, const ObjectModelFlags& flags,
                 const std::vector<TreeSample>& samples, const std::vector<BoxedFrame>& frames) {
  const ObjectModel model =
      FitModel(samples, ModelWithKnots(samples, group), group, flags.penalties, kMaxIterations);
  std::vector<BoxedFrame> own;
  for (const BoxedFrame& frame : frames) {
    if (GroupOf(frame.source) == group) own.push_back(frame);
  }
  DetectorOptions options = OptionsOf(flags);
  options.object_model = &model;
  const auto detect = [&](const RgbdFrame& frame) { return Detect(frame, options); };
  LeftOut left_out;
  const double size_m = options.voxels.size_m;
  for (std::size_t k = 0; k < kScoredShares.size(); ++k) {
    options.voxels.size_m = kScoredShares[k] * size_m;
    left_out.results[k] = RunBoxedFrames(own, detect, 1);
  }
  for (const TreeSample& sample : samples) {
    if (sample.group == group && sample.is_original) left_out.loss += LossOf(sample, model);
  }
  return left_out;
}

LeftOut LeaveOneOut(const ObjectModelFlags& flags, const std::vector<TreeSample>& samples,
                    const std::vector<BoxedFrame>& frames) {
  std::set<std::string> names;
  for (const BoxedFrame& frame : frames) names.insert(GroupOf(frame.source));
  const std::vector<std::string> groups(names.begin(), names.end());
  std::vector<LeftOut> of_group(groups.size());
  std::mutex mutex;  // guards done
  std::size_t done = 0;
  ForEachIndex(groups.size(), flags.num_threads, [&](std::size_t g) {
    of_group[g] = LeaveOut(groups[g], flags, samples, frames);
    const std::scoped_lock lock(mutex);
    ShowProgress("leaving one out", ++done, groups.size());
  });
  LeftOut all;
  for (const LeftOut& one : of_group) {
    for (std::size_t k = 0; k < kScoredShares.size(); ++k) {
      all.results[k].insert(all.results[k].end(), one.results[k].begin(), one.results[k].end());
    }
    all.loss += one.loss;
  }
  return all;
}

void PrintOverShares(const LeftOut& left_out) {
  double all = 0, mean = 0, clear = 0, least = 1, most = 0;
  bool has_clear = false;
  for (const std::vector<BoxedFrameResult>& results : left_out.results) {
    const BoxSummary summary = Summarize(results);
    const double f1 = summary.all.Boxes().f;
    all += f1 / kScoredShares.size();
    mean += summary.mean_f1 / kScoredShares.size();
    clear += summary.clear.Boxes().f / kScoredShares.size();
    has_clear = summary.has_clear;
    least = std::min(least, f1);
    most = std::max(most, f1);
  }
  fmt::print(
      "mean over voxels of {} sizes from {} to {} of theirs: F1 {:.1f} ({:.1f} to {:.1f}), mean of "
      "the sources {:.1f}{}\n",
      kScoredShares.size(), kScoredShares[1], kScoredShares.back(), 100 * all, 100 * least,
      100 * most, 100 * mean, has_clear ? fmt::format(", clear glass {:.1f}", 100 * clear) : "");
}

// Of each group of sources the required objects that some union of segments shows.
void PrintInTree(const std::vector<TreeSample>& samples, const std::vector<BoxedFrame>& frames) {
  std::map<std::string, int> required, found;
  for (const BoxedFrame& frame : frames) {
    required[GroupOf(frame.source)] +=
        static_cast<int>(std::count_if(frame.objects.begin(), frame.objects.end(),
                                       [](const BoxedObject& object) { return !object.optional; }));
  }
  for (const TreeSample& sample : samples) {
    if (sample.group.empty() || !sample.is_original) continue;
    found[sample.group] +=
        static_cast<int>(std::count(sample.states.begin(), sample.states.end(), NodeState::kIs));
  }
  int all_required = 0, all_found = 0;
  for (const auto& [group, count] : required) {
    fmt::print("{:<20} {:>4} of {:>4} in the tree\n", group, found[group], count);
    all_required += count;
    all_found += found[group];
  }
  fmt::print("{:<20} {:>4} of {:>4} in the tree\n", "all", all_found, all_required);
}

// By weight over all that is fitted to, and of the frames with boxes each as much, as what is left
// out is counted.
void PrintLoss(const std::vector<TreeSample>& samples, const ObjectModel& model) {
  double weight = 0, weighted = 0, loss_of_boxed = 0;
  int num_boxed = 0;
  for (const TreeSample& sample : samples) {
    const double loss = LossOf(sample, model);
    weight += sample.weight;
    weighted += sample.weight * loss;
    if (sample.group.empty() || !sample.is_original) continue;
    loss_of_boxed += loss;
    ++num_boxed;
  }
  fmt::print("{} trees, mean loss by weight {:.4f}", samples.size(), weighted / weight);
  if (num_boxed > 0) {
    fmt::print("; of {} frames with boxes {:.4f}", num_boxed, loss_of_boxed / num_boxed);
  }
  fmt::print("\n");
}

void Run(const ObjectModelFlags& flags) {
  std::vector<BoxedFrame> frames;
  const std::vector<TreeSample> samples = SampleAll(flags, frames);
  PrintInTree(samples, frames);
  const ObjectModel model =
      FitModel(samples, ModelWithKnots(samples, ""), "", flags.penalties, kMaxIterations);
  PrintLoss(samples, model);
  WriteText(flags.source, ToSource(model));
  if (!flags.leave_one_out) return;
  const LeftOut left_out = LeaveOneOut(flags, samples, frames);
  const std::vector<BoxedFrameResult>& results = left_out.results.front();
  fmt::print("{} frames left out, mean loss {:.4f}\n", frames.size(),
             left_out.loss / double(frames.size()));
  PrintBoxSummary(std::cout, "each group left out", Summarize(results));
  PrintOverShares(left_out);
  std::vector<Prediction> predictions;
  for (const BoxedFrameResult& result : results) {
    predictions.insert(predictions.end(), result.predictions.begin(), result.predictions.end());
  }
  const Reliability reliability = MeasureReliability(predictions);
  fmt::print("{:.1f} % of {} with confidence >= 0.8 are right, calibration error {:.3f}\n",
             100 * reliability.share_of_confident, reliability.confident,
             reliability.calibration_error);
}

}  // namespace

void AddObjectModelCommand(CLI::App& app) {
  auto flags = std::make_shared<ObjectModelFlags>();
  CLI::App* command = app.add_subcommand(
      "object-model", "Fit the model that tells objects from background and parts");
  auto* data = command->add_option_group("scenes");
  CLI::Option* boxes = data->add_option("--boxes", flags->boxes,
                                        "Folder of frames with boxes; DIR=WEIGHT weighs it");
  data->add_option("--mosd", flags->mosd, "Folder of <name>_{color,depth,label}.png as of mOSD");
  data->add_option("--data", flags->plain, "The same with label = object");
  data->require_option(1, 0);
  command->add_option("--intrinsics", flags->intrinsics, "FX,FY,CX,CY of the labelled scenes")
      ->delimiter(',')
      ->expected(4)
      ->capture_default_str();
  command->add_option("--penalty", flags->penalties.slope, "On slopes: evidence says less")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command->add_option("--bend-penalty", flags->penalties.bend, "On knots: functions are straighter")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command
      ->add_flag("--leave-one-out", flags->leave_one_out,
                 "Also score the frames of each group of sources by a model fitted without it")
      ->needs(boxes);
  command
      ->add_option("--source", flags->source,
                   "Write the model there: core/objects/fitted_object_model.cc")
      ->check(WhyNotWritable);
  command->add_option("--set", flags->settings, "name=value of a detector option; repeatable");
  command->add_option("--threads", flags->num_threads, "Scenes, or groups left out, at a time")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  command->callback([flags] { Run(*flags); });
}

}  // namespace fovea::evaluation
