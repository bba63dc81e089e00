// What `fovea-eval detection` can do with a folder of scenes.
#pragma once

#include <string>
#include <vector>

#include "core/options.h"
#include "tests/evaluation/dataset.h"

namespace fovea::evaluation {

struct DetectionFlags {
  std::string data;
  std::vector<double> intrinsics = {525, 525, 319.5, 239.5};
  LabelEncoding encoding = LabelEncoding::kMosd;
  std::string profile;
  std::vector<std::string> settings;  // name=value
  std::vector<std::string> sweeps;    // name=value,value…
  std::vector<std::string> methods;   // profiles and peers
  bool true_seeds = false;            // instead of salient positions
  bool with_effects = false;          // of other cameras
  int num_threads = 1;
  int num_repeats = 1;
  int num_folds = 5;
  bool print_scenes = false;
  std::string json;
  std::string plot;
  std::string overlays;
};

bool IsPeer(const std::string& method);

// `flags.settings` on top of a profile.
DetectorOptions OptionsOf(const DetectionFlags& flags, const std::string& profile);

// The picture of a scene; with the name of the row, if there are several.
std::string OverlayPath(const DetectionFlags& flags, const std::string& scene,
                        const std::string& row);

// Loads the scenes and prints one row per method, or else one per value of the sweeps or per camera
// effect, or else the scores of one run with its stage times; writes the files that are asked for.
// Throws std::invalid_argument for flags that do not go together.
void RunDetectionMode(const DetectionFlags& flags);

}  // namespace fovea::evaluation
