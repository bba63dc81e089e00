#include "tests/evaluation/generated/generated_flags.h"

#include <algorithm>

#include "tests/evaluation/output.h"
#include "tests/evaluation/settings.h"
#include "tests/support/random_scene.h"
#include "tests/support/sensor_names.h"

namespace fovea::evaluation {

void AddGeneratedFlags(CLI::App& command, GeneratedFlags& flags) {
  command.add_option("--kinds", flags.kinds, "Of scenes; all but empty_table unless told")
      ->delimiter(',')
      ->check(CLI::IsMember(scenes::SceneKinds()));
  command.add_option("--scenes", flags.num_scenes, "Of each kind, each seen by every sensor")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command.add_option("--seed", flags.first_seed, "Of the first scene of each kind")
      ->capture_default_str();
  command.add_option("--sensors", flags.sensors, "That see them")
      ->delimiter(',')
      ->check(CLI::IsMember(scenes::SensorsByName()))
      ->capture_default_str();
  command.add_option("--set", flags.settings, "name=value of a detector option; repeatable");
  command.add_flag("--gravity", flags.give_gravity, "Tell the detector where down is");
  command.add_option("--threads", flags.num_threads, "Scenes at a time")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
}

void AddFigureFlags(CLI::App& command, GeneratedFlags& flags) {
  command.add_option("--json", flags.json, "Write all figures to this file")->check(WhyNotWritable);
  command.add_option("--plot", flags.plot, "Write charts of them as SVG")->check(WhyNotWritable);
}

std::vector<std::string> KindsOf(const GeneratedFlags& flags) {
  if (!flags.kinds.empty()) return flags.kinds;
  std::vector<std::string> kinds = scenes::SceneKinds();
  std::erase(kinds, "empty_table");
  return kinds;
}

DetectorOptions OptionsOf(const GeneratedFlags& flags) {
  DetectorOptions options = OptionsOfProfile("default");
  ApplySettings(options, flags.settings);
  return options;
}

scenes::SensorKind SensorOf(const std::string& name) { return scenes::SensorsByName().at(name); }

}  // namespace fovea::evaluation
