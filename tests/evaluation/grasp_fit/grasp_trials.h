// Candidates for grasps of generated scenes, and whether each succeeds.
#pragma once

#include <array>
#include <vector>

#include "core/grasping/grasp_model.h"
#include "tests/evaluation/generated/generated_flags.h"
#include "tests/evaluation/grasp_fit/boosting.h"

namespace fovea::evaluation {

using GraspTrials = std::array<std::vector<GraspTrial>, kNumGraspFamilies>;

// Appends at most 40 candidates of each matched object and gripper: evenly spread over all that
// were judged, and the twenty that `model` takes for the likeliest, which are what is offered.
void TryGrasps(const GeneratedFlags& flags, const GraspModel& model, GraspTrials& trials);

// The functions fitted to the trials; prints what they are worth.
GraspModel FitGraspModel(const GraspTrials& trials);

// The source text of core/grasping/fitted_grasp_model.cc.
std::string ToSource(const GraspModel& model);

}  // namespace fovea::evaluation
