#include "server/conversion/shape.h"

#include "server/conversion/geometry.h"

namespace fovea::server {
namespace {

v1::ShapeKind KindToProto(Shape::Kind kind) {
  switch (kind) {
    case Shape::Kind::kOther:
      return v1::SHAPE_KIND_OTHER;
    case Shape::Kind::kBox:
      return v1::SHAPE_KIND_BOX;
    case Shape::Kind::kCylinder:
      return v1::SHAPE_KIND_CYLINDER;
    case Shape::Kind::kSphere:
      return v1::SHAPE_KIND_SPHERE;
    case Shape::Kind::kRevolution:
      return v1::SHAPE_KIND_REVOLUTION;
    case Shape::Kind::kFlat:
      return v1::SHAPE_KIND_FLAT;
  }
  return v1::SHAPE_KIND_UNSPECIFIED;
}

bool IsRound(Shape::Kind kind) {
  return kind == Shape::Kind::kCylinder || kind == Shape::Kind::kSphere ||
         kind == Shape::Kind::kRevolution;
}

}  // namespace

v1::Shape ToProto(const Shape& shape) {
  v1::Shape proto;
  proto.set_kind(KindToProto(shape.kind));
  proto.set_confidence(shape.confidence);
  proto.set_residual_m(shape.residual_m);
  if (IsRound(shape.kind)) {
    *proto.mutable_center() = ToProto(shape.center);
    if (shape.kind != Shape::Kind::kSphere) *proto.mutable_axis() = ToProto(shape.axis);
    proto.set_radius_m(shape.radius_m);
    proto.set_length_m(shape.length_m);
  }
  for (const float radius : shape.radii_m) proto.add_radii_m(radius);
  proto.set_hollow(shape.hollow);
  return proto;
}

}  // namespace fovea::server
