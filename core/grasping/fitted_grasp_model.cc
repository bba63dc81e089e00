// Made by `fovea-eval grasp-model`; see docs/quality.md.
#include "core/grasping/grasp_model.h"

namespace fovea {

const GraspModel& FittedGraspModel() {
  static const GraspModel kModel = {};
  return kModel;
}

}  // namespace fovea
