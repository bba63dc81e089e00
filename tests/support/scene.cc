#include "tests/support/scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace fovea::scenes {
namespace {

using Polygon = std::vector<Eigen::Vector2d>;

// True if an edge of `a` has all of `b` on its outer side, at least `gap_m` away.
bool HasSeparatingEdge(const Polygon& a, const Polygon& b, double gap_m) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Eigen::Vector2d edge = a[(i + 1) % a.size()] - a[i];
    const Eigen::Vector2d outwards = Eigen::Vector2d(edge.y(), -edge.x()).normalized();
    const bool separates = std::all_of(b.begin(), b.end(), [&](const Eigen::Vector2d& point) {
      return outwards.dot(point - a[i]) >= gap_m;
    });
    if (separates) return true;
  }
  return false;
}

bool StandsUpright(const Body& body) {
  return std::abs(body.world_from_body.linear()(2, 2)) > 0.999;
}

Polygon Circle(const Eigen::Vector2d& center, double radius) {
  constexpr int kCorners = 24;
  const double step = 2 * std::numbers::pi / kCorners;
  Polygon corners;
  for (int i = 0; i < kCorners; ++i) {
    const Eigen::Vector2d direction(std::cos(i * step), std::sin(i * step));
    corners.push_back(center + radius / std::cos(step / 2) * direction);
  }
  return corners;
}

}  // namespace

const Material& MaterialAt(const Body& body, const Hit& hit) {
  if (hit.material == 0) return body.material;
  return body.other_materials.at(static_cast<std::size_t>(hit.material) - 1);
}

std::vector<const Body*> ObjectsOf(const Scene& scene) {
  std::vector<const Body*> objects;
  for (const Body& body : scene.bodies) {
    if (body.is_object) objects.push_back(&body);
  }
  return objects;
}

Camera CameraOfSize(const cv::Size& size_px) {
  const double scale = size_px.width / 640.0;
  Camera camera;
  camera.size_px = size_px;
  camera.intrinsics = {525 * scale, 525 * scale, (size_px.width - 1) / 2.0,
                       (size_px.height - 1) / 2.0};
  return camera;
}

Eigen::Isometry3d LookAt(const Eigen::Vector3d& target, double distance_m, double pitch_rad,
                         double yaw_rad, double roll_rad) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  Eigen::Matrix3d level;  // columns: camera x, y, z in the world for a level view along +y
  level << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = AngleAxisd(yaw_rad, Vector3d::UnitZ()) *
                  AngleAxisd(-pitch_rad, Vector3d::UnitX()) * level *
                  AngleAxisd(roll_rad, Vector3d::UnitZ());
  pose.translation() = target - distance_m * pose.linear().col(2);
  return pose;
}

Scene Rolled(const Scene& scene, double roll_rad) {
  Scene rolled = scene;
  rolled.camera.world_from_camera.rotate(Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitZ()));
  return rolled;
}

std::pair<double, double> VerticalExtent(const Body& body) {
  const double z = body.world_from_body.translation().z();
  const Eigen::Vector3d up_in_body = body.world_from_body.linear().row(2).cwiseAbs();
  const double half = up_in_body.dot(body.shape.size_m) / 2;
  return {z - half, z + half};
}

std::vector<Eigen::Vector2d> Footprint(const Body& body) {
  const Eigen::Matrix3d axes = body.world_from_body.linear();
  const Eigen::Vector3d half = body.shape.size_m / 2;
  const Eigen::Vector2d center = body.world_from_body.translation().head<2>();
  if (body.shape.kind == ShapeKind::kSphere || (IsRound(body.shape.kind) && StandsUpright(body))) {
    return Circle(center, half.x());
  }
  int vertical = 0;
  axes.row(2).cwiseAbs().maxCoeff(&vertical);
  const int i = (vertical + 1) % 3, j = (vertical + 2) % 3;
  const Eigen::Vector2d a = half[i] * axes.col(i).head<2>();
  Eigen::Vector2d b = half[j] * axes.col(j).head<2>();
  if (a.x() * b.y() < a.y() * b.x()) b = -b;
  return {center - a - b, center + a - b, center + a + b, center - a + b};
}

bool Overlap(const Body& a, const Body& b, double gap_m) {
  constexpr double kContact_m = 1e-4;
  const auto [a_low, a_high] = VerticalExtent(a);
  const auto [b_low, b_high] = VerticalExtent(b);
  if (std::min(a_high, b_high) - std::max(a_low, b_low) <= kContact_m) return false;
  const Polygon pa = Footprint(a), pb = Footprint(b);
  return !HasSeparatingEdge(pa, pb, gap_m) && !HasSeparatingEdge(pb, pa, gap_m);
}

}  // namespace fovea::scenes
