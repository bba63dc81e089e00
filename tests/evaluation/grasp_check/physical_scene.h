// The true solids of a scene, for tests of what a hand would touch. World frame, metres.
#pragma once

#include <optional>
#include <vector>

#include "tests/evaluation/grasp_check/solid_box.h"
#include "tests/support/render.h"
#include "tests/support/scene.h"

namespace fovea::evaluation {

class PhysicalScene {
 public:
  // Samples the surfaces of what is no box, 2 mm apart. Refers to the scene, which must outlive it.
  explicit PhysicalScene(const scenes::Scene& scene);

  const scenes::Scene& Scene() const { return scene_; }

  // The body of the object with this label (1, 2, …; as scenes::ObjectTruth).
  int BodyOf(int label) const { return body_of_label_.at(static_cast<std::size_t>(label) - 1); }

  // Whether the body reaches into the box: exact for boxes and parts that are, else by samples.
  bool Touches(int body, const SolidBox& box) const;

  // Where the ray first meets this body, or else any; normals in the world frame.
  std::optional<scenes::Hit> Meets(int body, const scenes::Ray& ray, double max_t) const;
  std::optional<scenes::RayCaster::Result> Nearest(const scenes::Ray& ray) const;

 private:
  struct Solid {
    std::optional<SolidBox> box;
    std::vector<Eigen::Vector3d> surface;  // where it is no box
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    double radius_m = 0;  // of the sphere around it
  };
  static void AddSolids(const scenes::Shape& shape, const Eigen::Isometry3d& world_from_shape,
                        std::vector<Solid>& solids);

  const scenes::Scene& scene_;
  scenes::RayCaster caster_;
  std::vector<std::vector<Solid>> solids_;  // of each body
  std::vector<Eigen::Isometry3d> body_from_world_;
  std::vector<int> body_of_label_;
};

}  // namespace fovea::evaluation
