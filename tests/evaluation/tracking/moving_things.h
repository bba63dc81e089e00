// Generated streams in which something moves.
#pragma once

#include "tests/evaluation/tracking/streams.h"
#include "tests/support/random.h"
#include "tests/support/scene.h"

namespace fovea::evaluation {

// The scene from a camera that has gone around the world's z axis.
scenes::Scene SeenFromAround(const scenes::Scene& scene, double angle_rad);

// "moved" and "covered" of streams.h.
SceneStream MovedByAHand(const scenes::Scene& scene, scenes::Random& random);
SceneStream CoveredByAPanel(const scenes::Scene& scene, scenes::Random& random);

}  // namespace fovea::evaluation
