#include "tests/evaluation/object_figures/object_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "core/objects/color_names.h"
#include "tests/evaluation/generated/generated_run.h"
#include "tests/evaluation/generated/true_class.h"
#include "tests/evaluation/object_figures/relation_counts.h"
#include "tests/evaluation/object_figures/true_supports.h"
#include "tests/evaluation/statistics.h"

namespace fovea::evaluation {
namespace {

bool IsInOneColor(const scenes::Body& body) {
  return body.material.pattern == scenes::Pattern::kPlain && body.other_materials.empty();
}

// As a camera shows it in white light of full strength.
std::array<std::uint8_t, 3> Displayed(const scenes::Material& material) {
  constexpr double kGamma = 2.2;
  std::array<std::uint8_t, 3> rgb{};
  for (int i = 0; i < 3; ++i) {
    const double share = std::clamp(material.color[i], 0.0, 1.0);
    rgb[static_cast<std::size_t>(i)] =
        static_cast<std::uint8_t>(std::lround(255 * std::pow(share, 1 / kGamma)));
  }
  return rgb;
}

DescribedObject Describe(const GeneratedScene& scene, const GeneratedFrame& frame,
                         const MatchedObject& match, const scenes::Body& body) {
  const DetectedObject& answer = frame.detections.objects[match.answer];
  const TrueClass truth = ClassOf(body);
  DescribedObject object;
  object.kind = scene.kind;
  object.sensor = frame.sensor;
  object.name = body.name;
  object.what = truth.name;
  object.seed = scene.seed;
  object.visible_share = match.visible_share;
  object.true_shape = truth.accepted.front();
  object.answered_shape = answer.shape.kind;
  object.box = CompareBoxes(body, InWorld(answer.box, scene.scene.camera.world_from_camera));
  object.shape_is_right = std::find(truth.accepted.begin(), truth.accepted.end(),
                                    answer.shape.kind) != truth.accepted.end();
  object.shape_confidence = answer.shape.confidence;
  object.unseen_share = answer.unseen_share;
  object.uncertain = CompareUncertainBox(body, answer, scene.scene.camera.world_from_camera);
  if (IsInOneColor(body) && !answer.colors.empty()) {
    object.color_is_right = answer.colors.front().name == NameOfColor(Displayed(body.material));
  }
  return object;
}

void AddTimes(const Detections& detections, ObjectRun& run) {
  for (const StageTime& time : detections.stage_times) {
    if (time.stage != "objects") continue;
    run.num_objects.push_back(static_cast<double>(detections.objects.size()));
    run.objects_ms.push_back(time.duration_ms);
  }
}

ObjectRun DescribeScene(const GeneratedScene& scene) {
  const std::vector<const scenes::Body*> bodies = ObjectsOf(scene.scene);
  const std::vector<std::vector<int>> supports = TrueSupports(scene.scene);
  ObjectRun run;
  for (const GeneratedFrame& frame : scene.frames) {
    for (const MatchedObject& match : frame.matches) {
      run.objects.push_back(Describe(scene, frame, match, *bodies[match.truth]));
    }
    AddRelations(frame, supports, run);
    AddLeaning(scene.leaning, frame, run.leaning);
    AddTimes(frame.detections, run);
  }
  return run;
}

template <typename Value>
void Append(std::vector<Value>& to, std::vector<Value>& from) {
  std::move(from.begin(), from.end(), std::back_inserter(to));
}

}  // namespace

double TenObjectsMs(const ObjectRun& run) { return LineAt(10, run.num_objects, run.objects_ms); }

ObjectRun RunObjects(const GeneratedFlags& flags) {
  std::vector<ObjectRun> runs(NumScenes(flags));
  ForEachGeneratedScene(flags, OptionsOf(flags), [&](std::size_t i, const GeneratedScene& scene) {
    runs[i] = DescribeScene(scene);
  });
  ObjectRun all;
  for (ObjectRun& run : runs) {
    Append(all.objects, run.objects);
    Append(all.objects_ms, run.objects_ms);
    Append(all.num_objects, run.num_objects);
    all.on_objects.truth += run.on_objects.truth;
    all.on_objects.answered += run.on_objects.answered;
    all.on_objects.right += run.on_objects.right;
    all.leaning.truth += run.leaning.truth;
    all.leaning.answered += run.leaning.answered;
    all.leaning.right += run.leaning.right;
    all.stands_right += run.stands_right;
  }
  return all;
}

}  // namespace fovea::evaluation
