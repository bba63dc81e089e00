// Generated scenes in motion, at ten frames a second.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/scene.h"

namespace fovea::evaluation {

constexpr double kFrames_s = 0.1;  // from one to the next

struct SceneStream {
  std::vector<scenes::Scene> frames;
  // The thing that is covered for a while, by its label in MakeFrame; 0: none.
  int covered = 0;
};

// "still": nothing moves; 20 frames. "circle": the camera goes 90° around the middle of the scene
// in six seconds. "shake": it is held by a hand, 2 cm and 1.5° to and fro at 0.7 to 1.9 Hz, and
// drifts by 10 cm; four seconds. "moved": a hand lifts one of the things, carries it over a third
// of a metre at 0.3 m/s and puts it down. "covered": an arm with a panel comes between the camera,
// which goes on slowly, and one of the things, stays for a second and goes.
const std::vector<std::string>& StreamMotions();

// A scene of that kind (random_scene.h) in motion; the same seed gives the same stream. Throws
// std::invalid_argument for unknown names.
SceneStream RandomStream(const std::string& motion, const std::string& kind, std::uint64_t seed);

}  // namespace fovea::evaluation
