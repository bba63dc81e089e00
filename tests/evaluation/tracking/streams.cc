#include "tests/evaluation/tracking/streams.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/evaluation/tracking/moving_things.h"
#include "tests/support/random.h"
#include "tests/support/random_scene.h"

namespace fovea::evaluation {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using scenes::Random;

double Radians(double degrees) { return degrees * std::numbers::pi / 180; }

SceneStream Still(const scenes::Scene& scene, Random& /*random*/) {
  return {std::vector<scenes::Scene>(20, scene)};
}

SceneStream Circle(const scenes::Scene& scene, Random& /*random*/) {
  constexpr int kFrames = 60;
  SceneStream stream;
  for (int i = 0; i < kFrames; ++i) {
    stream.frames.push_back(SeenFromAround(scene, Radians(90.0 * i / (kFrames - 1) - 45)));
  }
  return stream;
}

SceneStream Shake(const scenes::Scene& scene, Random& random) {
  constexpr int kFrames = 40;
  Eigen::Matrix<double, 6, 1> rate_hz, phase;
  for (double& rate : rate_hz) rate = random.Uniform(0.7, 1.9);
  for (double& value : phase) value = random.Uniform(0, 6.28);
  const Vector3d drift(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
  SceneStream stream;
  for (int i = 0; i < kFrames; ++i) {
    const double t = kFrames_s * i;
    Eigen::Matrix<double, 6, 1> wave;
    for (int k = 0; k < 6; ++k)
      wave(k) = std::sin(2 * std::numbers::pi * rate_hz(k) * t + phase(k));
    const Vector3d turn = Radians(1.5) * wave.tail<3>();
    Isometry3d motion = Isometry3d::Identity();
    motion.linear() =
        AngleAxisd(turn.norm() + 1e-9, (turn + Vector3d(1e-9, 0, 0)).normalized()).matrix();
    motion.translation() = 0.02 * wave.head<3>() + 0.1 * (t / 4) * drift.normalized();
    scenes::Scene frame = scene;
    frame.camera.world_from_camera = scene.camera.world_from_camera * motion;
    stream.frames.push_back(std::move(frame));
  }
  return stream;
}

}  // namespace

const std::vector<std::string>& StreamMotions() {
  static const std::vector<std::string> motions = {"still", "circle", "shake", "moved", "covered"};
  return motions;
}

SceneStream RandomStream(const std::string& motion, const std::string& kind, std::uint64_t seed) {
  const scenes::Scene scene = scenes::RandomScene(kind, seed);
  Random random(seed * 8 + 5);
  if (motion == "still") return Still(scene, random);
  if (motion == "circle") return Circle(scene, random);
  if (motion == "shake") return Shake(scene, random);
  if (motion == "moved") return MovedByAHand(scene, random);
  if (motion == "covered") return CoveredByAPanel(scene, random);
  throw std::invalid_argument(motion + ": there is no such motion");
}

}  // namespace fovea::evaluation
