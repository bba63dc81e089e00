// A scene without a camera: solids, light and a pinhole view, all in plain structs.
//
// World frame: metres, z up, the floor at z = 0. Camera frame: optical (x right, y down,
// z forward). Transforms are named a_from_b: they take points of frame b to frame a.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core/types.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/types/rgbd_frame.h"
#include "tests/support/material.h"
#include "tests/support/shape.h"

namespace fovea::scenes {

struct Body {
  std::string name;
  Shape shape;
  Eigen::Isometry3d world_from_body = Eigen::Isometry3d::Identity();
  Material material;
  std::vector<Material> other_materials = {};  // of a compound's parts
  bool is_object = false;  // else part of the environment: floor, wall, furniture
};

// What the body is made of where it was hit.
const Material& MaterialAt(const Body& body, const Hit& hit);

// A horizontal rectangle on which objects stand.
struct Support {
  double height_m = 0;
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Vector2d half_size_m = Eigen::Vector2d::Zero();
};

struct Camera {
  CameraIntrinsics intrinsics = {525, 525, 319.5, 239.5};
  cv::Size size_px = {640, 480};
  Eigen::Isometry3d world_from_camera = Eigen::Isometry3d::Identity();
};

struct Light {
  Eigen::Vector3d towards = Eigen::Vector3d::UnitZ();  // unit vector, from the scene to the light
  double strength = 0.75;                              // on a surface that faces the light
  double ambient = 0.4;
};

struct Scene {
  std::vector<Body> bodies;
  std::vector<Support> supports;
  Camera camera;
  Light light;
};

// The bodies that are objects, in the order of their labels (1, 2, …).
std::vector<const Body*> ObjectsOf(const Scene& scene);

// Intrinsics of a 640×480 camera with 525 px focal length, scaled to another width.
Camera CameraOfSize(const cv::Size& size_px);

// The pose of a camera that sees `target` in the middle of its image, looking down by `pitch_rad`
// (0 = horizontal, π/2 = straight down) from `distance_m`, with heading `yaw_rad` (0 = along +y)
// and turned about its optical axis by `roll_rad`.
Eigen::Isometry3d LookAt(const Eigen::Vector3d& target, double distance_m, double pitch_rad,
                         double yaw_rad, double roll_rad);

// The scene, its camera turned about the optical axis by that much more.
Scene Rolled(const Scene& scene, double roll_rad);

// Lowest and highest z of a body whose frame has one axis vertical.
std::pair<double, double> VerticalExtent(const Body& body);

// A convex polygon, counter-clockwise in the xy plane, around the body seen from above; exact for
// boxes and lying cylinders, within 1 % of the radius for round shapes, the bounding rectangle for
// compounds.
std::vector<Eigen::Vector2d> Footprint(const Body& body);

// True if the two bodies share volume: their heights overlap by more than 0.1 mm, and their
// footprints overlap or, with a gap above 0, come closer than that.
bool Overlap(const Body& a, const Body& b, double gap_m = 0);

}  // namespace fovea::scenes
