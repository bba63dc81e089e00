// What surrounds the objects and is none: floor, walls, tables and other furniture.
#pragma once

#include "tests/support/random.h"
#include "tests/support/scene.h"

namespace fovea::scenes {

// A box that belongs to the environment, aligned with the world's axes.
Body Block(const std::string& name, const Eigen::Vector3d& center, const Eigen::Vector3d& size_m,
           const Material& material);

// Floor around the origin, a wall across +y and one across either -x or +x, `distance_m` away.
void AddRoom(Scene& scene, double distance_m, Random& random);

// A table with four legs. Adds its top to the scene's supports.
void AddTable(Scene& scene, const Eigen::Vector2d& center, const Eigen::Vector2d& size_m,
              double height_m, Random& random);

// A chair that faces -y.
void AddChair(Scene& scene, const Eigen::Vector2d& center, Random& random);

void AddCabinet(Scene& scene, const Eigen::Vector2d& center, Random& random);

}  // namespace fovea::scenes
