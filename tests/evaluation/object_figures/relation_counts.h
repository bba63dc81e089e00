// Which relations of matched objects are right.
#pragma once

#include <optional>
#include <vector>

#include "tests/evaluation/generated/generated_run.h"
#include "tests/evaluation/object_figures/object_run.h"

namespace fovea::evaluation {

// Counts a frame's `stands_on` beside what truly stands on what (`supports`, as TrueSupports).
// Pairs of which one was not matched count nowhere.
void AddRelations(const GeneratedFrame& frame, const std::vector<std::vector<int>>& supports,
                  ObjectRun& run);

// The same of `leans_on`.
void AddLeaning(const std::optional<scenes::LeaningThing>& truth, const GeneratedFrame& frame,
                Relations& leaning);

}  // namespace fovea::evaluation
