// Procedural surface colours.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace fovea::scenes {

enum class Pattern {
  kPlain,
  kStripes,  // rings along z
  kChecker,  // cubes
  kNoise,    // clouds
  kWood,     // clouds drawn out along x
  kPrint,    // a plain ground with a band of blocks, like the label of a package
};

struct Material {
  Pattern pattern = Pattern::kPlain;
  Eigen::Vector3d color = {0.5, 0.5, 0.5};  // linear RGB albedo, 0 … 1
  Eigen::Vector3d second_color = {0.5, 0.5, 0.5};
  double scale_m = 0.02;   // width of a stripe, side of a cube, size of a cloud
  std::uint32_t seed = 0;  // of the clouds
};

// Of one colour.
Material Plain(const Eigen::Vector3d& color);

// Linear RGB albedo at a point of the body, in the body's frame and metres.
Eigen::Vector3d AlbedoAt(const Material& material, const Eigen::Vector3d& point);

}  // namespace fovea::scenes
