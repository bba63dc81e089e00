#include "core/grasping/solid_pieces.h"

namespace fovea {
namespace {

SolidPiece BoxPiece(const Eigen::Vector3f& half) {
  SolidPiece piece;
  piece.half = half;
  return piece;
}

SolidPiece BallPiece(const Eigen::Vector3f& center, float radius_m) {
  SolidPiece piece;
  piece.kind = SolidPiece::Kind::kSphere;
  piece.center = center;
  piece.radius_m = radius_m;
  return piece;
}

SolidPiece RodPiece(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float radius_m) {
  SolidPiece piece;
  piece.kind = SolidPiece::Kind::kCylinder;
  piece.center = (from + to) / 2;
  piece.half_length_m = (to - from).norm() / 2;
  piece.axis = (to - from).normalized();
  piece.radius_m = radius_m;
  return piece;
}

// `axis`: in the axes of the box.
std::vector<SolidPiece> PiecesOfRevolution(const Shape& shape, const Eigen::Vector3f& axis) {
  std::vector<float> radii = shape.radii_m;
  if (radii.empty()) radii = {shape.radius_m};
  const float step = shape.length_m / static_cast<float>(radii.size());
  std::vector<SolidPiece> pieces;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const float low = static_cast<float>(i) * step - shape.length_m / 2;
    pieces.push_back(RodPiece(low * axis, (low + step) * axis, radii[i]));
  }
  return pieces;
}

std::vector<SolidPiece> PiecesOfOblong(const Eigen::Vector3f& half) {
  const float straight = half.x() - half.y();
  std::vector<SolidPiece> pieces = {BoxPiece({straight, half.y(), half.z()})};
  for (const float x : {-straight, straight}) {
    pieces.push_back(RodPiece({x, 0, -half.z()}, {x, 0, half.z()}, half.y()));
  }
  return pieces;
}

std::vector<SolidPiece> PiecesOfBent(const Shape& shape, const Eigen::Vector3f& half) {
  constexpr int kRods = 6;
  const float reach = half.x() - half.z();
  const auto at = [&](int i) {
    const float share = 2.0F * static_cast<float>(i) / kRods - 1;
    return Eigen::Vector3f(share * reach, shape.bend_m * (share * share - 0.5F), 0);
  };
  std::vector<SolidPiece> pieces = {BallPiece(at(0), half.z())};
  for (int i = 1; i <= kRods; ++i) {
    pieces.push_back(RodPiece(at(i - 1), at(i), half.z()));
    pieces.push_back(BallPiece(at(i), half.z()));
  }
  return pieces;
}

}  // namespace

std::vector<SolidPiece> PiecesOf(const DetectedObject& object) {
  const Shape& shape = object.shape;
  const Eigen::Vector3f half = object.box.size_m / 2;
  const Eigen::Vector3f axis = object.box.rotation.transpose() * shape.axis;
  switch (shape.kind) {
    case Shape::Kind::kSphere:
      return {BallPiece({0, 0, 0}, shape.radius_m)};
    case Shape::Kind::kCylinder:
      return {RodPiece(-shape.length_m / 2 * axis, shape.length_m / 2 * axis, shape.radius_m)};
    case Shape::Kind::kRevolution:
      return PiecesOfRevolution(shape, axis);
    case Shape::Kind::kBox:
    case Shape::Kind::kFlat:
      break;
    case Shape::Kind::kOther:
      if (shape.form == Shape::Form::kOblong) return PiecesOfOblong(half);
      if (shape.form == Shape::Form::kBent) return PiecesOfBent(shape, half);
  }
  return {BoxPiece(half)};
}

}  // namespace fovea
