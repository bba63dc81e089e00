#include "tests/evaluation/tracking/moving_things.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>
#include <string>

#include "tests/support/render.h"

namespace fovea::evaluation {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using scenes::Body;
using scenes::Random;

Body PartOfArm(const std::string& name, const Vector3d& center, const Vector3d& size_m,
               scenes::ShapeKind kind) {
  Body body;
  body.name = name;
  body.shape.kind = kind;
  body.shape.size_m = size_m;
  body.world_from_body.translation() = center;
  body.material.color = {0.7, 0.45, 0.35};
  return body;
}

// The object, by index among the bodies, that most of is seen of nearest to the middle.
struct Chosen {
  std::size_t body = 0;
  int label = 0;
};

Chosen MostVisible(const scenes::Scene& scene) {
  const cv::Mat labels = scenes::RenderLabels(scene);
  Chosen best;
  int most = 0, label = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (!scene.bodies[i].is_object) continue;
    const int pixels = cv::countNonZero(labels == ++label);
    if (pixels <= most) continue;
    most = pixels;
    best = {i, label};
  }
  return best;
}

// The way of a hand: up by 0.12 m, along, and down, at 0.3 m/s.
Vector3d OnTheWay(double way_m, const Vector3d& along) {
  constexpr double kUp_m = 0.12;
  const double across_m = along.norm();
  const double up_m = std::clamp(std::min(way_m, 2 * kUp_m + across_m - way_m), 0.0, kUp_m);
  const double share = std::clamp((way_m - kUp_m) / across_m, 0.0, 1.0);
  return share * along + Vector3d(0, 0, up_m);
}

// The clear place on the support that is about a third of a metre away; the nearest to that.
Vector3d PlaceToGo(const scenes::Scene& scene, const Body& body, Random& random) {
  Vector3d best(0.05, 0.05, 0);
  double least = 1;
  for (int trial = 0; trial < 200; ++trial) {
    const double angle = random.Uniform(0, 2 * std::numbers::pi);
    const Vector3d along =
        random.Uniform(0.15, 0.35) * Vector3d(std::cos(angle), std::sin(angle), 0);
    Body moved = body;
    moved.world_from_body.pretranslate(along);
    if (moved.world_from_body.translation().head<2>().norm() > 0.32) continue;
    const bool is_clear = std::none_of(
        scene.bodies.begin(), scene.bodies.end(),
        [&](const Body& other) { return &other != &body && scenes::Overlap(moved, other, 0.01); });
    const double off = std::abs(along.norm() - 0.33);
    if (!is_clear || off >= least) continue;
    least = off;
    best = along;
  }
  return best;
}

// 0: beside the view, 1: before the thing.
double InTheWay(int frame) {
  constexpr int kComes = 10, kIn = 4, kStays = 10;
  if (frame < kComes) return 0;
  if (frame < kComes + kIn) return (frame - kComes + 1) / (kIn + 1.0);
  if (frame < kComes + kIn + kStays) return 1;
  return std::max(0.0, 1 - (frame - kComes - kIn - kStays + 1) / (kIn + 1.0));
}

}  // namespace

scenes::Scene SeenFromAround(const scenes::Scene& scene, double angle_rad) {
  scenes::Scene turned = scene;
  turned.camera.world_from_camera =
      Eigen::AngleAxisd(angle_rad, Vector3d::UnitZ()) * scene.camera.world_from_camera;
  return turned;
}

SceneStream MovedByAHand(const scenes::Scene& scene, Random& random) {
  constexpr int kFrames = 40, kBefore = 8;
  constexpr double kMetresPerSecond = 0.3;
  const Chosen chosen = MostVisible(scene);
  const Body& body = scene.bodies[chosen.body];
  const Vector3d along = PlaceToGo(scene, body, random);
  const double top_m = scenes::VerticalExtent(body).second - body.world_from_body.translation().z();
  const double whole_m = along.norm() + 0.24;
  SceneStream stream;
  for (int i = 0; i < kFrames; ++i) {
    const double way_m = std::clamp((i - kBefore) * kFrames_s * kMetresPerSecond, 0.0, whole_m);
    scenes::Scene frame = scene;
    frame.bodies[chosen.body].world_from_body.pretranslate(OnTheWay(way_m, along));
    if (way_m > 0 && way_m < whole_m) {
      const Vector3d grip =
          frame.bodies[chosen.body].world_from_body.translation() + Vector3d(0, 0, top_m + 0.02);
      frame.bodies.push_back(PartOfArm("hand", grip, {0.07, 0.07, 0.05}, scenes::ShapeKind::kBox));
      frame.bodies.push_back(PartOfArm("arm", grip + Vector3d(0, 0, 0.3), {0.06, 0.06, 0.55},
                                       scenes::ShapeKind::kCylinder));
    }
    stream.frames.push_back(std::move(frame));
  }
  return stream;
}

SceneStream CoveredByAPanel(const scenes::Scene& scene, Random& random) {
  constexpr int kFrames = 40;
  const Chosen chosen = MostVisible(scene);
  const Body& body = scene.bodies[chosen.body];
  const double side = random.Chance(0.5) ? 1 : -1;
  // From 0.55 of the way to the thing, with room for the edges.
  constexpr double kShare = 0.55;
  const double wide_m = kShare * (body.shape.size_m.norm() + 0.06);
  SceneStream stream;
  stream.covered = chosen.label;
  for (int i = 0; i < kFrames; ++i) {
    scenes::Scene frame = SeenFromAround(scene, (6.0 * i / kFrames - 3) * std::numbers::pi / 180);
    const Isometry3d& camera = frame.camera.world_from_camera;
    const Vector3d target = camera.inverse() * body.world_from_body.translation();
    Body panel =
        PartOfArm("panel", Vector3d::Zero(), {wide_m, wide_m, 0.02}, scenes::ShapeKind::kBox);
    const Vector3d beside(side * (1 - InTheWay(i)) * 1.2 * target.z() * kShare, 0, 0);
    panel.world_from_body = camera * Eigen::Translation3d(kShare * target + beside);
    if (InTheWay(i) > 0) frame.bodies.push_back(panel);
    stream.frames.push_back(std::move(frame));
  }
  return stream;
}

}  // namespace fovea::evaluation
