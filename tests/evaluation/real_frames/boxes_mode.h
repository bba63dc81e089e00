// `fovea-eval detection --labels boxes`.
#pragma once

#include "tests/evaluation/detection_modes.h"

namespace fovea::evaluation {

// Loads the frames and prints the scores of one profile, or of `flags.methods` side by side; writes
// the files that are asked for. Throws std::invalid_argument for flags that need label images.
void RunBoxesMode(const DetectionFlags& flags);

}  // namespace fovea::evaluation
