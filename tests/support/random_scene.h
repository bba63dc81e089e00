// Random scenes of named kinds.
#pragma once

#include <cstdint>
#include <opencv2/core/types.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/scene.h"
#include "tests/support/scene_recipes.h"

namespace fovea::scenes {

// Those of scene_recipes.cc.
const std::vector<std::string>& SceneKinds();

// A scene of a kind; the same seed gives the same scene. Every object shows at least some 300
// pixels at 640×480. Throws std::invalid_argument for an unknown kind.
Scene RandomScene(std::string_view kind, std::uint64_t seed, const cv::Size& size_px = {640, 480});

// The same of a recipe of one's own.
Scene RandomScene(const Recipe& recipe, std::uint64_t seed, const cv::Size& size_px = {640, 480});

}  // namespace fovea::scenes
