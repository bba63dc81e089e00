#include "core/shape/seen_through.h"

#include <algorithm>
#include <array>
#include <opencv2/core.hpp>

#include "core/shape/surface_samples.h"
#include "core/types/projection.h"

namespace fovea {
namespace {

// How far it is to the object from a pixel outside of it in one direction; beyond the bounds: none.
constexpr int kNone = -1;
int StepsToObject(const cv::Mat& labels, cv::Point pixel, const cv::Point& step, int label,
                  const cv::Rect& bounds) {
  for (int steps = 1; bounds.contains(pixel += step); ++steps) {
    if (labels.at<std::uint16_t>(pixel) == label) return steps;
  }
  return kNone;
}

bool IsOfObject(const cv::Mat& labels, const cv::Point& pixel, int label, const cv::Rect& bounds) {
  constexpr int kEdge_px = 3;
  const std::array<cv::Point, 4> kWays = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
  if (labels.at<std::uint16_t>(pixel) == label) return true;
  int num_sides = 0;
  for (const cv::Point& way : kWays) {
    const int steps = StepsToObject(labels, pixel, way, label, bounds);
    if (steps == kNone) continue;
    if (steps <= kEdge_px) return true;
    ++num_sides;
  }
  return num_sides == 4;
}

}  // namespace

float SeenThroughShare(const SeenScene& scene, int label, const cv::Rect& bounds,
                       const Solid& solid, const LevelFrame& frame) {
  // Depth noise grows with the square of the distance (Khoshelham and Elberink 2012).
  constexpr float kTolerance_m = 0.008F, kTolerancePerM = 0.004F;
  constexpr int kAround_px = 4;
  const cv::Rect image({}, scene.labels.size());
  const cv::Rect around =
      image & cv::Rect(bounds.x - kAround_px, bounds.y - kAround_px, bounds.width + 2 * kAround_px,
                       bounds.height + 2 * kAround_px);
  float through = 0, all = 0;
  for (const SurfaceSample& sample : SampleSurface(solid)) {
    const Eigen::Vector3f at = frame.ToCamera(sample.position);
    const float facing = -(frame.rotation * sample.normal).dot(at);
    if (at.z() <= 0 || facing <= 0) continue;
    const float size = sample.area_m2 * facing;
    all += size;
    const cv::Point pixel(Project(at, scene.intrinsics));
    if (!image.contains(pixel)) continue;
    const float seen_m = scene.points.at<cv::Vec3f>(pixel)[2];  // NaN: nothing is known
    const bool is_behind = seen_m > at.z() + kTolerance_m + kTolerancePerM * at.z() * at.z();
    if (is_behind && !IsOfObject(scene.labels, pixel, label, around)) through += size;
  }
  return all > 0 ? through / all : 0;
}

}  // namespace fovea
