#include "core/grasping/grasp_terms.h"

#include <algorithm>

#include "core/grasping/hidden_border.h"
#include "core/grasping/silhouette.h"

namespace fovea {
namespace {

// 1 of what is round, 0 of what has flat sides or is not known, between them of what has both.
float Roundness(const Shape& shape) {
  using Kind = Shape::Kind;
  switch (shape.kind) {
    case Kind::kSphere:
    case Kind::kCylinder:
    case Kind::kRevolution:
      return 1;
    case Kind::kBox:
    case Kind::kFlat:
      return 0;
    case Kind::kOther:
      break;
  }
  return shape.form == Shape::Form::kUnknown ? 0 : 0.5F;
}

}  // namespace

GraspTerms TermsOfObject(const GraspScene& scene, const DetectedObject& object) {
  using Kind = Shape::Kind;
  const Kind kind = object.shape.kind;
  GraspTerms terms{};
  terms[kTermDistance] = object.box.center.norm();
  terms[kTermConfidence] = object.confidence;
  // The model was fitted to no value where nothing was measured.
  terms[kTermUnseen] = object.depth_missing ? 0 : object.unseen_share;
  terms[kTermTruncated] = object.truncated ? 1 : 0;
  const bool is_known = kind != Kind::kOther || object.shape.form != Shape::Form::kUnknown;
  terms[kTermShapeSure] = is_known ? object.shape.confidence : 0;
  terms[kTermRound] = Roundness(object.shape);
  terms[kTermResidual] = std::min(2.0F, kCentimetres * object.shape.residual_m);
  terms[kTermFlat] = kind == Kind::kFlat ? 1 : 0;
  terms[kTermHeight] = std::min(15.0F, kCentimetres * object.box.size_m.z());
  terms[kTermDepthMissing] = object.depth_missing ? 1 : 0;
  const Eigen::Vector3f& size = object.box.size_m;
  terms[kTermSlender] = std::min(3.0F, 2 * size.z() / std::max(0.001F, size.x() + size.y()));
  terms[kTermHiddenBorder] = HiddenShareOfBorder(scene, object);
  terms[kTermHollow] = object.shape.hollow ? 1 : 0;
  const Silhouette silhouette = SilhouetteOf(scene, object);
  terms[kTermSeenThrough] = silhouette.seen_through;
  terms[kTermBesideSolid] = silhouette.beside;
  return terms;
}

}  // namespace fovea
