#include "core/grasping/suction_places.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/grasping/sight.h"
#include "core/types/projection.h"

namespace fovea {
namespace {

using Kind = Shape::Kind;

constexpr float kWall_m = 0.004F;  // of bowls and cups, about

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
    case Kind::kBox:
    case Kind::kFlat:
      return {FaceTowards(object.box, patch.normal), 0};
    case Kind::kSphere:
      return {from.normalized(), 1 / shape.radius_m};
    case Kind::kCylinder: {
      const float along = shape.axis.dot(patch.normal);
      if (std::abs(along) > kOnTop) return {along > 0 ? shape.axis : -shape.axis, 0};
      return {(from - shape.axis * shape.axis.dot(from)).normalized(), 1 / shape.radius_m};
    }
    case Kind::kOther:
      if (shape.form == Shape::Form::kOblong) return {FaceTowards(object.box, patch.normal), 0};
      break;
    case Kind::kRevolution:
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

// With places of the completed solid before it is known what is seen of them.
class SolidSpots {
 public:
  void Add(const Eigen::Vector3f& center, const Eigen::Vector3f& normal, float curvature_per_m,
           bool is_inside = false) {
    SuctionPlace place;
    place.center = center;
    place.normal = normal;
    place.curvature_per_m = curvature_per_m;
    place.of_solid = true;
    place.is_inside = is_inside;
    places.push_back(place);
  }

  void AddFaces(const OrientedBox& box) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const float sign : {-1.0F, 1.0F}) {
        const Eigen::Vector3f normal = sign * box.rotation.col(axis);
        Add(box.center + normal * box.size_m[axis] / 2, normal, 0);
      }
    }
  }

  void AddCylinder(const Shape& shape, const Eigen::Vector3f& approach) {
    for (const float sign : {-1.0F, 1.0F}) {
      const Eigen::Vector3f normal = sign * shape.axis;
      Add(shape.center + normal * shape.length_m / 2, normal, 0);
    }
    const Eigen::Vector3f across = shape.axis * shape.axis.dot(approach) - approach;
    if (across.norm() < 0.1F) return;
    const Eigen::Vector3f normal = across.normalized();
    Add(shape.center + normal * shape.radius_m, normal, 1 / shape.radius_m);
  }

  void AddRevolution(const Shape& shape) {
    const float half = shape.length_m / 2;
    if (!shape.hollow) return Add(shape.center + shape.axis * half, shape.axis, 0);
    Add(shape.center + shape.axis * (kWall_m - half), shape.axis, 0, true);
  }

  std::vector<SuctionPlace> places;
};

std::vector<SuctionPlace> SpotsOf(const DetectedObject& object, const Eigen::Vector3f& approach) {
  const Shape& shape = object.shape;
  SolidSpots spots;
  switch (shape.kind) {
    case Kind::kBox:
    case Kind::kFlat:
      spots.AddFaces(object.box);
      break;
    case Kind::kSphere:
      spots.Add(shape.center - approach * shape.radius_m, -approach, 1 / shape.radius_m);
      break;
    case Kind::kCylinder:
      spots.AddCylinder(shape, approach);
      break;
    case Kind::kRevolution:
      spots.AddRevolution(shape);
      break;
    case Kind::kOther:
      if (shape.form == Shape::Form::kOblong) spots.AddFaces(object.box);
      break;
  }
  return spots.places;
}

// The radius of the bottom of what is hollow.
float InsideOf(const Shape& shape) {
  return (shape.radii_m.empty() ? shape.radius_m : shape.radii_m.front()) - kWall_m;
}

// Of the solid under a lip and its middle: heights over the place.
struct UnderLip {
  float low = 1, high = -1;  // of the lip
  float middle = 0;
};

// None where a part of the lip meets nothing. `u`: across the normal, where the lip is looked at
// first.
std::optional<UnderLip> LookUnderLip(const CompletedSolid& solid, const Eigen::Vector3f& center,
                                     const Eigen::Vector3f& normal, const Eigen::Vector3f& u,
                                     float radius_m) {
  constexpr float kAbove_m = 0.05F;
  const Eigen::Vector3f v = normal.cross(u);
  Lines lines;
  for (const auto& [c, s] : kAroundLip) {
    lines.Add(center + radius_m * (c * u + s * v) + kAbove_m * normal, -normal);
  }
  lines.Add(center + kAbove_m * normal, -normal);
  std::vector<Span> spans;
  solid.Along(lines, spans);
  UnderLip under;
  for (const Span& span : spans) {
    if (span.IsEmpty()) return std::nullopt;
    if (&span == &spans.back()) break;
    under.low = std::min(under.low, kAbove_m - span.low);
    under.high = std::max(under.high, kAbove_m - span.low);
  }
  under.middle = kAbove_m - spans.back().low;
  return under;
}

// Whether the solid is even to a lip of this radius.
bool IsEvenAt(const CompletedSolid& solid, const Eigen::Vector3f& center,
              const Eigen::Vector3f& normal, float radius_m, const SuctionGripper& cup) {
  const auto under = LookUnderLip(solid, center, normal, normal.unitOrthogonal(), radius_m);
  if (!under || under->high - under->low > 2 * cup.max_unevenness_m) return false;
  const float rise = under->middle - (under->low + under->high) / 2;
  return std::abs(rise) <= cup.max_unevenness_m + cup.max_curvature_per_m * radius_m * radius_m / 2;
}

}  // namespace

std::vector<SuctionPlace> SeenPlaces(const GraspScene& scene, const DetectedObject& object,
                                     float diameter_m, int& num_missed) {
  constexpr int kAcross = 8;
  std::vector<SuctionPlace> places;
  const cv::Rect& bounds = object.bounds_px;
  for (int i = 0; i < kAcross; ++i) {
    for (int j = 0; j < kAcross; ++j) {
      const cv::Point pixel(bounds.x + (2 * j + 1) * bounds.width / (2 * kAcross),
                            bounds.y + (2 * i + 1) * bounds.height / (2 * kAcross));
      if (scene.labels.at<std::uint16_t>(pixel) != object.label) continue;
      const auto& point = scene.points.ptr<Eigen::Vector3f>(pixel.y)[pixel.x];
      const auto patch = PatchAt(scene, object.label, pixel, point, diameter_m);
      if (!patch) {
        ++num_missed;
        continue;
      }
      const Surface surface = SurfaceAt(object, *patch);
      places.push_back({pixel, patch->center, surface.normal, surface.curvature_per_m, *patch});
    }
  }
  return places;
}

std::vector<SuctionPlace> SolidPlaces(const GraspScene& scene, const DetectedObject& object,
                                      const Eigen::Vector3f& approach, float diameter_m) {
  std::vector<SuctionPlace> places = SpotsOf(object, approach);
  const cv::Rect image({}, scene.labels.size());
  std::erase_if(places, [&](SuctionPlace& place) {
    const Sight sight = SightOf(scene, object.label, place.center);
    if (sight == Sight::kFree || sight == Sight::kOutsideOfImage) return true;
    const cv::Point2d at = Project(place.center, scene.intrinsics);
    place.pixel = {cvRound(at.x), cvRound(at.y)};
    if (!image.contains(place.pixel)) return true;
    const auto patch = PatchAt(scene, object.label, place.pixel, place.center, diameter_m);
    place.seen.normal = place.normal;
    if (patch) place.seen = *patch;
    return false;
  });
  return places;
}

bool IsOnSolid(const DetectedObject& object, const CompletedSolid& solid, const LevelFrame& frame,
               const SuctionPlace& place, const SuctionGripper& cup, float radius_m) {
  constexpr float kCos = 0.923879533F, kSin = 0.382683432F;  // of a sixteenth of a turn
  if (place.is_inside) return radius_m <= InsideOf(object.shape);
  const Eigen::Vector3f center = frame.FromCamera(place.center);
  const Eigen::Vector3f normal = frame.rotation.transpose() * place.normal;
  const Eigen::Vector3f u = normal.unitOrthogonal(), between = kCos * u + kSin * normal.cross(u);
  const auto first = LookUnderLip(solid, center, normal, u, radius_m);
  if (!first) return false;
  const auto second = LookUnderLip(solid, center, normal, between, radius_m);
  if (!second) return false;
  return std::max(first->high, second->high) - std::min(first->low, second->low) <=
         2 * cup.max_unevenness_m;
}

float EvenReach(const DetectedObject& object, const CompletedSolid& solid, const LevelFrame& frame,
                const SuctionPlace& place, const SuctionGripper& cup) {
  constexpr float kMost = 2;
  if (!solid.IsKnown()) return 1;
  const float lip_radius = cup.diameter_m / 2;
  if (place.is_inside) {
    return std::clamp(InsideOf(object.shape) / lip_radius, 0.0F, kMost);
  }
  const Eigen::Vector3f center = frame.FromCamera(place.center);
  const Eigen::Vector3f normal = frame.rotation.transpose() * place.normal;
  float reach = 0;
  for (const float times : {0.6F, 0.8F, 1.0F, 1.1F, 1.2F, 1.35F, 1.5F, 1.75F, kMost}) {
    if (!IsEvenAt(solid, center, normal, times * lip_radius, cup)) break;
    reach = times;
  }
  return reach;
}

}  // namespace fovea
