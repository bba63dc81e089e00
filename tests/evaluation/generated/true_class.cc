#include "tests/evaluation/generated/true_class.h"

#include <algorithm>
#include <set>

namespace fovea::evaluation {
namespace {

using Kind = Shape::Kind;
using scenes::ShapeKind;

bool StandsUpright(const scenes::Body& body) {
  return std::abs(body.world_from_body.linear()(2, 2)) > 0.999;
}

TrueClass OfCompound(const scenes::Body& body) {
  static const std::set<std::string> kRound = {"bottle", "torch", "pear"};
  static const std::set<std::string> kWithHandle = {"mug", "pitcher", "pan"};
  if (kRound.contains(body.name)) {
    return StandsUpright(body) ? TrueClass{"compound", {Kind::kRevolution, Kind::kCylinder}}
                               : TrueClass{"compound", {Kind::kCylinder, Kind::kOther}};
  }
  if (kWithHandle.contains(body.name)) return {"compound", {Kind::kRevolution, Kind::kOther}};
  if (body.name == "keyboard") return {"compound", {Kind::kOther, Kind::kBox}};
  return {"compound", {Kind::kOther}};
}

TrueClass OfAnyHeight(const scenes::Body& body) {
  switch (body.shape.kind) {
    case ShapeKind::kBox:
      return {"box", {Kind::kBox}};
    case ShapeKind::kCylinder:
      return {StandsUpright(body) ? "can" : "tube", {Kind::kCylinder}};
    case ShapeKind::kSphere:
      return {"ball", {Kind::kSphere}};
    case ShapeKind::kBowl:
    case ShapeKind::kCup:
      return {"vessel", {Kind::kRevolution}};
    case ShapeKind::kCushion:
      return {"soft", {Kind::kOther}};
    case ShapeKind::kCompound:
      return OfCompound(body);
  }
  return {};
}

}  // namespace

TrueClass ClassOf(const scenes::Body& body) {
  constexpr double kFlat_m = 0.03;
  TrueClass result = OfAnyHeight(body);
  const auto [low, high] = VerticalExtent(body);
  if (high - low >= kFlat_m) return result;
  result.name = "flat";
  result.accepted.insert(result.accepted.begin(), Kind::kFlat);
  return result;
}

bool IsRoundUpright(const scenes::Body& body) {
  if (body.shape.kind == ShapeKind::kSphere) return true;
  if (!StandsUpright(body)) return false;
  if (body.shape.kind != ShapeKind::kCompound) return IsRound(body.shape.kind);
  return std::all_of(
      body.shape.parts.begin(), body.shape.parts.end(), [](const scenes::Part& part) {
        const Eigen::Isometry3d& pose = part.shape_from_part;
        return IsRound(part.shape.kind) && pose.translation().head<2>().norm() < 1e-6 &&
               (std::abs(pose.linear()(2, 2)) > 0.999 || part.shape.kind == ShapeKind::kSphere);
      });
}

}  // namespace fovea::evaluation
