// How many annotated objects of RGB-D Scenes are detected (paper section 4.2, Table 4 and Fig. 8).
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/options.h"
#include "core/types/rgbd_frame.h"
#include "tests/evaluation/rgbd_scenes/annotations.h"

namespace fovea::evaluation {

// A video of one place: `<name>.mat` beside the folder `<name>` with frames
// `<name>_<number>.png` and `<name>_<number>_depth.png` (16 bits, millimetres).
struct Scenario {
  std::string name;  // for example "table_small_1"
  std::filesystem::path folder;
  std::vector<std::vector<AnnotatedObject>> objects;  // of each frame, number 1 first
};

// All scenarios in a folder and the folders in it, by name. Throws std::runtime_error if there are
// none, or of ReadAnnotations.
std::vector<Scenario> FindScenarios(const std::filesystem::path& data);

struct DetectionRate {
  int objects = 0;   // annotated
  int detected = 0;  // of them, with a box of IoU > 0.5, one to one
};

// Detects in each frame of the scenario that is there; `done` is called after each. Other objects
// are not annotated, so precision cannot be told. Throws std::runtime_error for an image that
// cannot be read, or a scenario without frames.
DetectionRate RateOf(const Scenario& scenario, const CameraIntrinsics& intrinsics,
                     const DetectorOptions& options, const std::function<void()>& done = {});

// The paper's Table 4: objects and percent detected; nothing for other names.
struct PublishedRate {
  int objects = 0;
  double percent = 0;
};
PublishedRate PublishedRateOf(const std::string& scenario);

}  // namespace fovea::evaluation
