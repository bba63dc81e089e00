#include "tests/evaluation/grasp_check/physical_scene.h"

#include <algorithm>

#include "tests/evaluation/grasp_check/body_surface.h"

namespace fovea::evaluation {

PhysicalScene::PhysicalScene(const scenes::Scene& scene) : scene_(scene), caster_(scene) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const scenes::Body& body = scene.bodies[i];
    if (body.is_object) body_of_label_.push_back(static_cast<int>(i));
    body_from_world_.push_back(body.world_from_body.inverse());
    AddSolids(body.shape, body.world_from_body, solids_.emplace_back());
  }
}

void PhysicalScene::AddSolids(const scenes::Shape& shape, const Eigen::Isometry3d& world_from_shape,
                              std::vector<Solid>& solids) {
  constexpr double kSpacing_m = 0.002;
  for (const scenes::Part& part : shape.parts) {
    AddSolids(part.shape, world_from_shape * part.shape_from_part, solids);
  }
  if (shape.kind == scenes::ShapeKind::kCompound) return;
  Solid solid = {{}, {}, world_from_shape.translation(), shape.size_m.norm() / 2};
  if (shape.kind == scenes::ShapeKind::kBox) {
    solid.box = SolidBox{world_from_shape, shape.size_m / 2};
  } else {
    solid.surface = SampleSurface(shape, kSpacing_m);
    for (Eigen::Vector3d& point : solid.surface) point = world_from_shape * point;
  }
  solids.push_back(std::move(solid));
}

bool PhysicalScene::Touches(int body, const SolidBox& box) const {
  const double reach_m = box.half_m.norm();
  const auto touches = [&](const Solid& solid) {
    const Eigen::Vector3d apart = solid.center - box.world_from_box.translation();
    if (apart.norm() > reach_m + solid.radius_m) return false;
    if (solid.box) return Meet(*solid.box, box);
    return std::any_of(solid.surface.begin(), solid.surface.end(),
                       [&](const Eigen::Vector3d& point) { return Contains(box, point); });
  };
  const std::vector<Solid>& solids = solids_[static_cast<std::size_t>(body)];
  return std::any_of(solids.begin(), solids.end(), touches);
}

std::optional<scenes::Hit> PhysicalScene::Meets(int body, const scenes::Ray& ray,
                                                double max_t) const {
  const auto index = static_cast<std::size_t>(body);
  const Eigen::Isometry3d& body_from_world = body_from_world_[index];
  const scenes::Ray in_body = {body_from_world * ray.origin,
                               body_from_world.linear() * ray.direction};
  auto hit = Intersect(scene_.bodies[index].shape, in_body, max_t);
  if (hit) hit->normal = (body_from_world.linear().transpose() * hit->normal).eval();
  return hit;
}

std::optional<scenes::RayCaster::Result> PhysicalScene::Nearest(const scenes::Ray& ray) const {
  return caster_.Nearest(ray);
}

}  // namespace fovea::evaluation
