// Figures of boxes, shapes and relations as text.
#pragma once

#include <ostream>

#include "tests/evaluation/object_figures/object_run.h"

namespace fovea::evaluation {

void PrintObjects(std::ostream& out, const ObjectRun& run);

}  // namespace fovea::evaluation
