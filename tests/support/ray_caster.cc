#include <limits>

#include "tests/support/render.h"

namespace fovea::scenes {
namespace {

// Whether the ray's line passes the sphere.
bool Misses(const Ray& ray, const Eigen::Vector3d& center, double squared_radius_m2) {
  const Eigen::Vector3d to_center = center - ray.origin;
  const double along = to_center.dot(ray.direction), length = ray.direction.squaredNorm();
  const double squared = to_center.squaredNorm();
  if (along < 0 && squared > squared_radius_m2) return true;  // behind
  return squared * length - along * along > squared_radius_m2 * length;
}

Ray Transformed(const Eigen::Isometry3d& transform, const Ray& ray) {
  return {transform * ray.origin, transform.linear() * ray.direction};
}

}  // namespace

RayCaster::RayCaster(const Scene& scene) {
  for (const Body& body : scene.bodies) {
    instances_.push_back({&body.shape, body.world_from_body.inverse(),
                          body.world_from_body.translation(), body.shape.size_m.squaredNorm() / 4});
  }
}

std::optional<RayCaster::Result> RayCaster::Nearest(const Ray& ray) const {
  std::optional<Result> nearest;
  for (std::size_t i = 0; i < instances_.size(); ++i) {
    const Instance& instance = instances_[i];
    if (Misses(ray, instance.center, instance.squared_radius_m2)) continue;
    const double max_t = nearest ? nearest->hit.t : std::numeric_limits<double>::infinity();
    const auto hit = Intersect(*instance.shape, Transformed(instance.body_from_world, ray), max_t);
    if (hit) nearest = {static_cast<int>(i), *hit};
  }
  if (nearest) {
    const auto to_world = instances_[nearest->body].body_from_world.linear().transpose();
    nearest->hit.normal = (to_world * nearest->hit.normal).eval();
  }
  return nearest;
}

bool RayCaster::Blocked(const Ray& ray, double max_t) const {
  for (const Instance& instance : instances_) {
    if (Misses(ray, instance.center, instance.squared_radius_m2)) continue;
    if (Intersect(*instance.shape, Transformed(instance.body_from_world, ray), max_t)) return true;
  }
  return false;
}

}  // namespace fovea::scenes
