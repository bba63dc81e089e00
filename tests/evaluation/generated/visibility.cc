#include "tests/evaluation/generated/visibility.h"

#include <algorithm>
#include <opencv2/core.hpp>

#include "tests/support/render.h"

namespace fovea::evaluation {

std::vector<int> PixelsAlone(const scenes::Scene& scene) {
  scenes::Scene alone;
  alone.camera = scene.camera;
  alone.camera.size_px = scene.camera.size_px * 2;
  alone.camera.intrinsics.cx_px += scene.camera.size_px.width / 2.0;
  alone.camera.intrinsics.cy_px += scene.camera.size_px.height / 2.0;
  std::vector<int> pixels;
  for (const scenes::Body& body : scene.bodies) {
    if (!body.is_object) continue;
    alone.bodies = {body};
    pixels.push_back(std::max(1, cv::countNonZero(scenes::RenderLabels(alone))));
  }
  return pixels;
}

std::string VisibilityName(double visible_share) {
  if (visible_share < 0.4) return "seen < 0.4";
  if (visible_share < 0.7) return "seen 0.4-0.7";
  return visible_share < 0.9 ? "seen 0.7-0.9" : "seen >= 0.9";
}

}  // namespace fovea::evaluation
