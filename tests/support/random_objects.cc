#include "tests/support/random_objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fovea::scenes {
namespace {

Body Named(const char* name, ShapeKind kind, const Eigen::Vector3d& size_m, double wall_m = 0) {
  Body body;
  body.name = name;
  body.shape = {kind, size_m, wall_m, {}};
  return body;
}

Body RoundObject(const char* name, ShapeKind kind, double diameter_m, double height_m,
                 double wall_m = 0) {
  return Named(name, kind, {diameter_m, diameter_m, height_m}, wall_m);
}

Body RandomForm(Random& random) {
  const auto metres = [&](double low, double high) { return random.Uniform(low, high); };
  switch (random.Integer(0, 9)) {
    case 0:
    case 1:
    case 2:
      return Named("box", ShapeKind::kBox,
                   {metres(0.06, 0.18), metres(0.04, 0.12), metres(0.05, 0.22)});
    case 3:
      return Named("book", ShapeKind::kBox,
                   {metres(0.17, 0.26), metres(0.12, 0.18), metres(0.015, 0.045)});
    case 4:
    case 5:
      return RoundObject("can", ShapeKind::kCylinder, metres(0.055, 0.1), metres(0.08, 0.2));
    case 6: {
      Body tube = RoundObject("tube", ShapeKind::kCylinder, metres(0.05, 0.08), metres(0.12, 0.25));
      tube.world_from_body.linear() =
          Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitY()).matrix();
      return tube;
    }
    case 7: {
      const double diameter = metres(0.06, 0.13);
      return RoundObject("ball", ShapeKind::kSphere, diameter, diameter);
    }
    case 8:
      return RoundObject("bowl", ShapeKind::kBowl, metres(0.12, 0.19), metres(0.045, 0.065), 0.005);
    default:
      return RoundObject("cup", ShapeKind::kCup, metres(0.07, 0.095), metres(0.07, 0.11), 0.005);
  }
}

}  // namespace

Material RandomMaterial(Random& random) {
  constexpr std::array kPatterns = {Pattern::kPlain,   Pattern::kPlain, Pattern::kStripes,
                                    Pattern::kChecker, Pattern::kNoise, Pattern::kPrint,
                                    Pattern::kPrint};
  Material material;
  material.pattern = random.Pick(kPatterns);
  const double hue = random.Unit();
  material.color = ColorOf(hue, random.Uniform(0.3, 0.95), random.Uniform(0.3, 0.95));
  material.second_color =
      ColorOf(hue + random.Uniform(0.2, 0.8), random.Uniform(0, 0.8), random.Uniform(0.25, 1));
  material.scale_m = random.Uniform(0.012, 0.035);
  material.seed = static_cast<std::uint32_t>(random.Bits());
  return material;
}

Body RandomObject(Random& random, double scale) {
  Body body = RandomForm(random);
  body.shape.size_m *= scale;
  body.material = RandomMaterial(random);
  body.is_object = true;
  Rest(body, Eigen::Vector2d::Zero(), 0, 0);
  return body;
}

bool HasFlatTop(const Body& body) {
  const bool upright = std::abs(body.world_from_body.linear()(2, 2)) > 0.999;
  return body.shape.kind == ShapeKind::kBox || (body.shape.kind == ShapeKind::kCylinder && upright);
}

void Rest(Body& body, const Eigen::Vector2d& center, double height_m, double yaw_rad) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  body.world_from_body.linear() = (turn * body.world_from_body.linear()).eval();
  const auto [low, high] = VerticalExtent(body);
  body.world_from_body.translation() << center, height_m + (high - low) / 2;
}

Eigen::Vector3d ColorOf(double hue, double saturation, double value) {
  Eigen::Vector3d color;
  for (int channel = 0; channel < 3; ++channel) {
    const double phase = std::fmod(hue * 6 + 6 - 2 * channel, 6);
    const double share = std::clamp(std::abs(phase - 3) - 1, 0.0, 1.0);
    color[channel] = std::pow(value * (1 - saturation * (1 - share)), 2.2);
  }
  return color;
}

}  // namespace fovea::scenes
