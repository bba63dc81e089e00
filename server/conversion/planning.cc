#include "server/conversion/planning.h"

#include <bit>

#include "server/conversion/field_error.h"
#include "server/conversion/geometry.h"

namespace fovea::server {
namespace {

static_assert(std::endian::native == std::endian::little);

v1::CollisionKind KindToProto(CollisionPrimitive::Kind kind) {
  switch (kind) {
    case CollisionPrimitive::Kind::kBox:
      return v1::COLLISION_KIND_BOX;
    case CollisionPrimitive::Kind::kCylinder:
      return v1::COLLISION_KIND_CYLINDER;
    case CollisionPrimitive::Kind::kSphere:
      return v1::COLLISION_KIND_SPHERE;
  }
  return v1::COLLISION_KIND_UNSPECIFIED;
}

// A rotation to the last digits of double.
v1::Pose PoseToProto(const Eigen::Isometry3f& pose) {
  const Eigen::Quaterniond orientation(pose.linear().cast<double>());
  return ToProto(Eigen::Isometry3d(Eigen::Translation3d(pose.translation().cast<double>()) *
                                   orientation.normalized()));
}

}  // namespace

v1::CollisionPrimitive ToProto(const CollisionPrimitive& primitive) {
  v1::CollisionPrimitive proto;
  proto.set_kind(KindToProto(primitive.kind));
  *proto.mutable_pose() = PoseToProto(primitive.pose);
  *proto.mutable_size() = ToProto(primitive.size_m);
  return proto;
}

v1::HeightMap ToProto(const HeightMap& map) {
  v1::HeightMap proto;
  *proto.mutable_pose() = PoseToProto(map.pose);
  proto.set_cell_m(map.cell_m);
  proto.set_width(static_cast<std::uint32_t>(map.heights_m.cols));
  proto.set_height(static_cast<std::uint32_t>(map.heights_m.rows));
  proto.set_data(map.heights_m.data, map.heights_m.total() * sizeof(float));
  return proto;
}

PlanningOptions PlanningFromProto(const v1::DetectOptions& options) {
  constexpr double kLeastCell_m = 0.002, kMostCell_m = 1;
  constexpr std::uint32_t kMostCells = 1 << 20;
  PlanningOptions result;
  result.collision_primitives = options.planning().collision_primitives();
  result.height_map = options.planning().has_height_map();
  const v1::HeightMapOptions& map = options.planning().height_map();
  if (map.cell_m() != 0) {
    RequireField(map.cell_m() >= kLeastCell_m && map.cell_m() <= kMostCell_m,
                 "options.planning.height_map.cell_m", "must be 0 (0.02) or from 0.002 to 1 m");
    result.cell_m = static_cast<float>(map.cell_m());
  }
  RequireField(map.max_cells() <= kMostCells, "options.planning.height_map.max_cells",
               "must be 0 (65536) or at most 1048576");
  if (map.max_cells() > 0) result.max_cells = static_cast<int>(map.max_cells());
  return result;
}

}  // namespace fovea::server
