#include "tests/evaluation/detection_command.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "tests/evaluation/output.h"
#include "tests/evaluation/report.h"

namespace fovea::evaluation {
namespace {

struct Flags {
  std::string data;
  std::vector<double> intrinsics = {525, 525, 319.5, 239.5};
  LabelEncoding encoding = LabelEncoding::kMosd;
  std::string profile;
  std::vector<std::string> settings;
  std::vector<std::string> sweeps;
  int num_threads = 1;
  int num_folds = 5;
  bool print_scenes = false;
  std::string json;
  std::string overlays;
};

// name=value,value… → the name and the values.
std::pair<std::string, std::vector<double>> ParseSetting(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) throw std::invalid_argument(text + ": expected name=value");
  std::vector<double> values;
  for (const std::string& value : CLI::detail::split(text.substr(equals + 1), ',')) {
    values.push_back(std::stod(value));
  }
  return {text.substr(0, equals), values};
}

std::vector<Scene> LoadScenes(const Flags& flags) {
  const std::vector<double>& k = flags.intrinsics;
  const std::vector<std::string> names = SceneNames(flags.data);
  std::vector<Scene> scenes;
  for (const std::string& name : names) {
    scenes.push_back(LoadScene(flags.data, name, flags.encoding, {k[0], k[1], k[2], k[3]}));
    ShowProgress("reading  ", scenes.size(), names.size());
  }
  return scenes;
}

std::vector<SceneResult> Evaluate(const Flags& flags, const std::vector<Scene>& scenes,
                                  const DetectorOptions& options) {
  std::size_t done = 0;
  return RunDetection(scenes, options, flags.num_threads,
                      [&](const Scene& scene, const Detections& detections) {
                        ShowProgress("detecting", ++done, scenes.size());
                        if (flags.overlays.empty()) return;
                        cv::imwrite(flags.overlays + "/" + scene.name + "_overlay.png",
                                    DrawOverlay(scene, detections.labels));
                      });
}

void RunOnce(const Flags& flags, const std::vector<Scene>& scenes, const DetectorOptions& options) {
  const std::vector<SceneResult> results = Evaluate(flags, scenes, options);
  const Summary summary = Summarize(results, flags.num_folds);
  if (flags.print_scenes) PrintScenes(std::cout, results);
  PrintSummaryHeader(std::cout);
  PrintSummaryRow(std::cout, std::to_string(results.size()) + " scenes", summary);
  PrintStages(std::cout, summary);
  WriteJson(flags.json, {{"options", OptionValues(options)},
                         {"summary", ToJson(summary)},
                         {"scenes", ToJson(results)}});
}

// One row per value; several sweeps run one after the other, each from the same start.
void RunSweeps(const Flags& flags, const std::vector<Scene>& scenes,
               const DetectorOptions& options) {
  nlohmann::json rows = nlohmann::json::array();
  PrintSummaryHeader(std::cout);
  for (const std::string& sweep : flags.sweeps) {
    const auto [name, values] = ParseSetting(sweep);
    for (const double value : values) {
      DetectorOptions changed = options;
      SetOption(changed, name, value);
      const Summary summary = Summarize(Evaluate(flags, scenes, changed), flags.num_folds);
      std::ostringstream title;
      title << name << '=' << value;
      PrintSummaryRow(std::cout, title.str(), summary);
      rows.push_back({{"name", name}, {"value", value}, {"summary", ToJson(summary)}});
    }
  }
  WriteJson(flags.json, rows);
}

void Run(const Flags& flags) {
  DetectorOptions options = OptionsOfProfile(flags.profile);
  for (const std::string& setting : flags.settings) {
    const auto [name, values] = ParseSetting(setting);
    SetOption(options, name, values.at(0));
  }
  if (!flags.overlays.empty()) std::filesystem::create_directories(flags.overlays);
  const std::vector<Scene> scenes = LoadScenes(flags);
  if (flags.sweeps.empty()) {
    RunOnce(flags, scenes, options);
  } else {
    RunSweeps(flags, scenes, options);
  }
}

}  // namespace

void AddDetectionCommand(CLI::App& app) {
  auto flags = std::make_shared<Flags>();
  CLI::App* command = app.add_subcommand("detection", "Score the detector on labelled scenes");
  command->add_option("--data", flags->data, "Folder of <name>_{color,depth,label}.png")
      ->required()
      ->check(CLI::ExistingDirectory);
  command->add_option("--intrinsics", flags->intrinsics, "FX,FY,CX,CY of the frames in pixels")
      ->delimiter(',')
      ->expected(4)
      ->capture_default_str();
  const std::map<std::string, LabelEncoding> encodings = {{"mosd", LabelEncoding::kMosd},
                                                          {"plain", LabelEncoding::kPlain}};
  command
      ->add_option("--labels", flags->encoding,
                   "mosd: object = value / 10 from 20 on (the default); plain: object = value")
      ->transform(CLI::CheckedTransformer(encodings));
  command->add_option("--profile", flags->profile, "Options to start from")
      ->check(CLI::IsMember(ProfileNames()));
  command->add_option("--set", flags->settings, "name=value of a detector option; repeatable");
  command->add_option("--sweep", flags->sweeps,
                      "name=v1,v2,… : a row of scores for each value; repeatable");
  command->add_option("--threads", flags->num_threads, "Scenes detected at a time")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  command->add_option("--folds", flags->num_folds, "Groups of scenes for the spread of box F1")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  command->add_flag("--scenes", flags->print_scenes, "Print a line per scene");
  command->add_option("--json", flags->json, "Write all scores to this file");
  command->add_option("--overlays", flags->overlays, "Write a picture per scene to this folder");
  command->callback([flags] { Run(*flags); });
}

}  // namespace fovea::evaluation
