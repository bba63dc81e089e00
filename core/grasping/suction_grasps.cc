#include "core/grasping/suction_grasps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/grasping/jaw_grasps.h"
#include "core/grasping/suction_patch.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr float kCentimetres = 100;
constexpr float kTube_m = 0.15F;  // of the tube behind the cup that must be free

// Pixels of the object, spread evenly; the nearest to the middle of its mask among them.
std::vector<cv::Point> PixelsToTry(const GraspScene& scene, const DetectedObject& object) {
  constexpr int kAcross = 8;
  std::vector<cv::Point> pixels;
  const cv::Rect& bounds = object.bounds_px;
  for (int i = 0; i < kAcross; ++i) {
    for (int j = 0; j < kAcross; ++j) {
      const cv::Point pixel(bounds.x + (2 * j + 1) * bounds.width / (2 * kAcross),
                            bounds.y + (2 * i + 1) * bounds.height / (2 * kAcross));
      if (scene.labels.at<std::uint16_t>(pixel) == object.label) pixels.push_back(pixel);
    }
  }
  return pixels;
}

// The smallest distance between the tube and what else is in the columns of the grid, up to 20 mm;
// negative where they meet.
float TubeGap(const HandGrid& grid, const Eigen::Vector3f& center, const Eigen::Vector3f& normal,
              float radius_m) {
  constexpr float kFarthest_m = 0.02F, kOnPatch_m = 0.006F;
  // Around the tube, cosines and sines of multiples of 45 degrees.
  constexpr float kHalf = 0.70710678F;
  constexpr std::array<std::pair<float, float>, 8> kAround = {{{1, 0},
                                                               {kHalf, kHalf},
                                                               {0, 1},
                                                               {-kHalf, kHalf},
                                                               {-1, 0},
                                                               {-kHalf, -kHalf},
                                                               {0, -1},
                                                               {kHalf, -kHalf}}};
  const Eigen::Vector3f start = grid.frame.FromCamera(center);
  const Eigen::Vector3f way = grid.frame.rotation.transpose() * normal;
  const Eigen::Vector3f u = way.unitOrthogonal(), v = way.cross(u);
  float gap = kFarthest_m;
  for (float along = kOnPatch_m; along < kTube_m; along += 0.01F) {
    for (const float wider : {0.0F, 0.005F, 0.01F, 0.02F}) {
      for (const auto& [c, s] : kAround) {
        const Eigen::Vector3f at = start + along * way + (radius_m + wider) * (c * u + s * v);
        const int x = grid.CellAt(at.x()), y = grid.CellAt(at.y());
        if (x < 0 || y < 0 || x >= grid.size || y >= grid.size) continue;
        if (grid.At(y, x).other <= at.z()) continue;
        gap = std::min(gap, wider > 0 ? wider - 0.005F : -kFarthest_m);
      }
    }
  }
  return gap;
}

struct Surface {
  Eigen::Vector3f normal;
  float curvature_per_m = 0;
};

// The face of a box that faces a patch most.
Eigen::Vector3f FaceTowards(const OrientedBox& box, const Eigen::Vector3f& normal) {
  const Eigen::Vector3f cosines = box.rotation.transpose() * normal;
  Eigen::Index axis = 0;
  cosines.cwiseAbs().maxCoeff(&axis);
  return cosines[axis] > 0 ? box.rotation.col(axis) : Eigen::Vector3f(-box.rotation.col(axis));
}

Surface SurfaceOf(const DetectedObject& object, const SuctionPatch& patch) {
  constexpr float kOnTop = 0.7F;  // cosine
  const Shape& shape = object.shape;
  const Eigen::Vector3f from = patch.center - shape.center;
  switch (shape.kind) {
    case Shape::Kind::kBox:
    case Shape::Kind::kFlat:
      return {FaceTowards(object.box, patch.normal), 0};
    case Shape::Kind::kSphere:
      return {from.normalized(), 1 / shape.radius_m};
    case Shape::Kind::kCylinder: {
      const float along = shape.axis.dot(patch.normal);
      if (std::abs(along) > kOnTop) return {along > 0 ? shape.axis : -shape.axis, 0};
      return {(from - shape.axis * shape.axis.dot(from)).normalized(), 1 / shape.radius_m};
    }
    case Shape::Kind::kRevolution:
    case Shape::Kind::kOther:
      break;
  }
  return {patch.normal, patch.curvature_per_m};
}

// Of the solid that the object is taken for, which is surer than that of a noisy patch, where the
// two agree; else that of the patch.
Surface SurfaceAt(const DetectedObject& object, const SuctionPatch& patch) {
  constexpr float kAgree = 0.9F;  // cosine: 26 degrees
  const Surface surface = SurfaceOf(object, patch);
  return surface.normal.dot(patch.normal) > kAgree ? surface
                                                   : Surface{patch.normal, patch.curvature_per_m};
}

// A lip follows more than the largest curvature where that is still even to it.
constexpr float kMostCurvature = 2.2F;  // times the largest

bool IsEven(const SuctionPatch& patch, const SuctionGripper& cup, float noise_m) {
  constexpr float kLeastCovered = 0.6F;
  return patch.unevenness_m < cup.max_unevenness_m + 2 * noise_m && patch.covered >= kLeastCovered;
}

// Of a few sizes from that of the cup on, the widest that would lie on the object.
float UsableDiameter(const GraspScene& scene, const DetectedObject& object, const cv::Point& pixel,
                     const SuctionGripper& cup, float noise_m) {
  float usable = cup.diameter_m;
  for (const float times : {1.25F, 1.5F, 2.0F, 3.0F}) {
    const auto wider = PatchAt(scene, object.label, pixel, times * cup.diameter_m);
    if (!wider || !IsEven(*wider, cup, noise_m)) break;
    usable = times * cup.diameter_m;
  }
  return usable;
}

}  // namespace

std::vector<ScoredGrasp> FindSuctionGrasps(const GraspScene& scene, const DetectedObject& object,
                                           const HandGrid& grid, const Gripper& gripper,
                                           std::size_t index, Failures& failures) {
  constexpr float kNoise_m = 0.001F, kNoisePerM = 0.002F;  // of depth, per square metre
  const auto& cup = std::get<SuctionGripper>(gripper.hand);
  const Eigen::Vector3f approach = -grid.frame.rotation.col(2);
  const GraspTerms of_object = TermsOfObject(scene, object);
  std::vector<ScoredGrasp> grasps;
  for (const cv::Point& pixel : PixelsToTry(scene, object)) {
    InterruptionPoint();
    const auto patch = PatchAt(scene, object.label, pixel, cup.diameter_m);
    if (!patch) {
      failures.Add(NoGrasp::Reason::kTooLittleSeen);
      continue;
    }
    const float noise = kNoise_m + kNoisePerM * patch->center.z() * patch->center.z();
    const Surface surface = SurfaceAt(object, *patch);
    const Eigen::Vector3f& normal = surface.normal;
    const float cosine = -normal.dot(approach), curvature = surface.curvature_per_m;
    if (!IsEven(*patch, cup, noise) || curvature > kMostCurvature * cup.max_curvature_per_m) {
      failures.Add(NoGrasp::Reason::kNoSeal);
      continue;
    }
    if (cosine < std::cos(gripper.max_tilt_rad)) {
      failures.Add(NoGrasp::Reason::kSloped);
      continue;
    }
    const float gap = TubeGap(grid, patch->center, normal, cup.diameter_m / 2);
    if (gap < 0) {
      failures.Add(NoGrasp::Reason::kNeighbor);
      continue;
    }
    const Eigen::Vector3f to_middle = object.box.center - patch->center;
    const float off_center = (to_middle - normal * to_middle.dot(normal)).norm();
    ScoredGrasp scored;
    scored.family = GraspFamily::kSuction;
    scored.terms = of_object;
    GraspTerms& t = scored.terms;
    t[kTermUnevenness] = std::min(4.0F, patch->unevenness_m / noise);
    t[kTermCurvature] = std::min(4.0F, curvature / cup.max_curvature_per_m);
    t[kTermTilt] = std::sqrt(std::max(0.0F, 1 - cosine * cosine));
    t[kTermOffCenter] = std::min(4.0F, off_center / cup.diameter_m);
    t[kTermCovered] = patch->covered;
    t[kTermTubeGap] = kCentimetres * gap;
    t[kTermPoints] = std::min(2.0F, static_cast<float>(patch->num_points) / 100);
    t[kTermDisagrees] = normal.cross(patch->normal).norm();
    Grasp& grasp = scored.grasp;
    grasp.kind = Grasp::Kind::kSuction;
    grasp.gripper = index;
    grasp.tool_center_point = patch->center;
    grasp.approach = -normal;
    grasp.closing = normal.unitOrthogonal();
    grasp.clearance_m = gap;
    grasp.unevenness_m = patch->unevenness_m;
    grasp.off_center_m = off_center;
    grasp.usable_diameter_m = UsableDiameter(scene, object, pixel, cup, noise);
    t[kTermUsable] = std::min(2.0F, kCentimetres * (grasp.usable_diameter_m - cup.diameter_m) / 2);
    grasps.push_back(scored);
  }
  return grasps;
}

}  // namespace fovea
