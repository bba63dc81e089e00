#include "tests/evaluation/generated/generated_run.h"

#include <mutex>
#include <utility>

#include "tests/evaluation/generated/matching.h"
#include "tests/evaluation/generated/true_class.h"
#include "tests/evaluation/generated/visibility.h"
#include "tests/evaluation/output.h"
#include "tests/evaluation/parallel.h"
#include "tests/support/random_scene.h"

namespace fovea::evaluation {
namespace {

GeneratedFrame Look(const GeneratedScene& scene, const std::string& sensor, bool give_gravity,
                    const DetectorOptions& options, const std::vector<int>& pixels_alone) {
  GeneratedFrame frame;
  frame.sensor = sensor;
  frame.labelled = scenes::MakeFrame(scene.scene, SensorOf(sensor), scene.seed);
  if (give_gravity) frame.labelled.frame.gravity = frame.labelled.gravity;
  Trace trace;
  frame.detections = Detect(frame.labelled.frame, options, &trace);
  frame.grasp_candidates = std::move(trace.grasp_candidates);
  const std::vector<const scenes::Body*> objects = ObjectsOf(scene.scene);
  for (const auto& [truth, answer] :
       MatchMasks(frame.labelled.labels, frame.detections.labels, frame.labelled.frame.depth_m)) {
    const auto i = static_cast<std::size_t>(truth) - 1;
    const double share = double(frame.labelled.objects[i].num_pixels) / pixels_alone[i];
    frame.matches.push_back(
        {i, static_cast<std::size_t>(answer) - 1, share, ClassOf(*objects[i]).name});
  }
  return frame;
}

}  // namespace

std::size_t NumScenes(const GeneratedFlags& flags) {
  return KindsOf(flags).size() * static_cast<std::size_t>(flags.num_scenes);
}

void ForEachGeneratedScene(const GeneratedFlags& flags, const DetectorOptions& options,
                           const std::function<void(std::size_t, const GeneratedScene&)>& visit) {
  const std::vector<std::string> kinds = KindsOf(flags);
  const std::size_t count = NumScenes(flags), each = static_cast<std::size_t>(flags.num_scenes);
  std::mutex mutex;  // guards done
  std::size_t done = 0;
  ForEachIndex(count, flags.num_threads, [&](std::size_t i) {
    GeneratedScene scene = {kinds[i / each], flags.first_seed + i % each, {}, {}, {}};
    scene.scene = scenes::RandomScene(scene.kind, scene.seed);
    if (flags.leaning) scene.leaning = scenes::AddLeaningThing(scene.scene, scene.seed);
    const std::vector<int> pixels_alone = PixelsAlone(scene.scene);
    for (const std::string& sensor : flags.sensors) {
      scene.frames.push_back(Look(scene, sensor, flags.give_gravity, options, pixels_alone));
    }
    visit(i, scene);
    const std::scoped_lock lock(mutex);
    ShowProgress("scenes", ++done, count);
  });
}

}  // namespace fovea::evaluation
