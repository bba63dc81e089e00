#include "tests/support/compound_parts.h"

#include <numbers>
#include <utility>

namespace fovea::scenes {
namespace {

Part PartAt(const Eigen::Vector3d& center, const Shape& shape, int material) {
  Part part = {shape, Eigen::Isometry3d::Identity(), material};
  part.shape_from_part.translation() = center;
  return part;
}

}  // namespace

Part BlockPart(const Eigen::Vector3d& center, const Eigen::Vector3d& size_m, int material) {
  return PartAt(center, {ShapeKind::kBox, size_m, 0, {}}, material);
}

Part BallPart(const Eigen::Vector3d& center, double diameter_m, int material) {
  const Eigen::Vector3d size_m = Eigen::Vector3d::Constant(diameter_m);
  return PartAt(center, {ShapeKind::kSphere, size_m, 0, {}}, material);
}

Part RodPart(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double diameter_m,
             int material) {
  const Eigen::Vector3d along = to - from;
  const Shape rod = {ShapeKind::kCylinder, {diameter_m, diameter_m, along.norm()}, 0, {}};
  Part part = PartAt((from + to) / 2, rod, material);
  part.shape_from_part.linear() =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), along).toRotationMatrix();
  return part;
}

Part DiskPart(double low_m, double high_m, double diameter_m, int material) {
  return RodPart({0, 0, low_m}, {0, 0, high_m}, diameter_m, material);
}

Part VesselPart(double diameter_m, double height_m, double wall_m) {
  const Shape cup = {ShapeKind::kCup, {diameter_m, diameter_m, height_m}, wall_m, {}};
  return PartAt({0, 0, height_m / 2}, cup, 0);
}

void AddBentRod(std::vector<Part>& parts, const std::vector<Eigen::Vector3d>& points,
                double diameter_m, int material) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (i > 1) parts.push_back(BallPart(points[i - 1], diameter_m, material));
    parts.push_back(RodPart(points[i - 1], points[i], diameter_m, material));
  }
}

Part Turned(Part part, double angle_rad, const Eigen::Vector3d& axis) {
  const Eigen::AngleAxisd turn(angle_rad, axis);
  part.shape_from_part.linear() = (turn * part.shape_from_part.linear()).eval();
  return part;
}

Body Compound(const char* name, std::vector<Part> parts) {
  Body body;
  body.name = name;
  body.shape = CompoundOf(std::move(parts));
  return body;
}

Body SometimesLying(Body body, double share, Random& random) {
  if (random.Chance(share)) {
    body.world_from_body.linear() =
        Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitY()).matrix();
  }
  return body;
}

}  // namespace fovea::scenes
