// The detector on generated scenes, whose solids are known.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/detector.h"
#include "tests/evaluation/generated/generated_flags.h"
#include "tests/support/labelled_frame.h"
#include "tests/support/leaning.h"
#include "tests/support/scene.h"

namespace fovea::evaluation {

// A true object and the answer for it.
struct MatchedObject {
  std::size_t truth = 0;     // index into LabelledFrame::objects
  std::size_t answer = 0;    // index into Detections::objects
  double visible_share = 0;  // of the pixels that it would show alone, in the image or beyond
  std::string what;          // as TrueClass::name
};

struct GeneratedFrame {
  std::string sensor;
  scenes::LabelledFrame labelled;
  Detections detections;
  // Of each of its objects, every grasp that was judged.
  std::vector<std::vector<ScoredGrasp>> grasp_candidates;
  std::vector<MatchedObject> matches;  // masks with IoU > 0.5 where there is depth
};

struct GeneratedScene {
  std::string kind;
  std::uint64_t seed = 0;
  scenes::Scene scene;
  std::optional<scenes::LeaningThing> leaning;
  std::vector<GeneratedFrame> frames;  // one for each sensor
};

// Calls visit(i, scene) for scene i of NumScenes, several at a time. The same flags and options
// give the same scenes and answers, with any number of threads. Noise has the scene's seed.
std::size_t NumScenes(const GeneratedFlags& flags);
void ForEachGeneratedScene(const GeneratedFlags& flags, const DetectorOptions& options,
                           const std::function<void(std::size_t, const GeneratedScene&)>& visit);

}  // namespace fovea::evaluation
