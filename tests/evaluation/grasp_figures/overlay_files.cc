#include "tests/evaluation/grasp_figures/overlay_files.h"

#include <fmt/format.h>

#include <algorithm>

#include "tests/evaluation/grasp_check/check_grasp.h"
#include "tests/evaluation/grasp_figures/grasp_overlay.h"
#include "tests/support/scene_files.h"

namespace fovea::evaluation {
namespace {

std::string FileNameOf(const Gripper& gripper) {
  std::string name = gripper.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

}  // namespace

void WriteOverlays(const std::string& folder, const GeneratedScene& scene,
                   const std::vector<Gripper>& grippers) {
  const PhysicalScene physical(scene.scene);
  for (const GeneratedFrame& frame : scene.frames) {
    for (std::size_t g = 0; g < grippers.size(); ++g) {
      std::vector<EndedGrasp> ended;
      for (const MatchedObject& match : frame.matches) {
        const std::vector<Grasp>& grasps = frame.detections.objects[match.answer].grasps;
        const auto first = std::find_if(grasps.begin(), grasps.end(),
                                        [g](const Grasp& grasp) { return grasp.gripper == g; });
        if (first == grasps.end()) continue;
        const int body = physical.BodyOf(frame.labelled.objects[match.truth].label);
        ended.push_back({*first, CheckGrasp(physical, body, grippers[g], *first)});
      }
      if (ended.empty()) continue;
      const std::string path = fmt::format("{}/{}_{}_{}_{}.png", folder, scene.kind, scene.seed,
                                           frame.sensor, FileNameOf(grippers[g]));
      scenes::WriteImage(path, DrawGrasps(frame.labelled.frame, grippers[g], ended));
    }
  }
}

}  // namespace fovea::evaluation
