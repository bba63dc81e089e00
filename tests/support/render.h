// What an ideal camera sees of a scene: one ray through the centre of each pixel.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "tests/support/scene.h"

namespace fovea::scenes {

// The bodies of a scene, ready for rays. Refers to the scene, which must outlive it.
class RayCaster {
 public:
  explicit RayCaster(const Scene& scene);

  struct Result {
    int body = 0;  // index into Scene::bodies
    Hit hit;       // world frame
  };

  // The nearest body along the ray (world frame).
  std::optional<Result> Nearest(const Ray& ray) const;

  // True if a body lies between the ray's origin and t = max_t.
  bool Blocked(const Ray& ray, double max_t) const;

 private:
  struct Instance {
    const Shape* shape;
    Eigen::Isometry3d body_from_world;
    Eigen::Vector3d center;
    double squared_radius_m2;  // of the sphere around the body
  };
  std::vector<Instance> instances_;
};

// All images have the camera's size.
struct Rendering {
  cv::Mat color;    // CV_32FC3, linear RGB, 1 = white; sky where nothing is hit
  cv::Mat depth_m;  // CV_32FC1, along z, NaN where nothing is hit
  cv::Mat labels;   // CV_16UC1, 0 = not an object, k = the k-th object among the bodies
  cv::Mat cosine;   // CV_32FC1, of the angle between the surface normal and the ray; 0 for none
  cv::Mat in_second_view;  // CV_8UC1, 255 where the second eye or the projector of the sensor,
                           // `baseline_m` to the right of the camera, reaches the same point
};

// Renders in parallel; the same scene gives the same bytes.
Rendering Render(const Scene& scene, double baseline_m = 0);

// Labels or depth alone, as Rendering::labels and depth_m: many times faster.
cv::Mat RenderLabels(const Scene& scene);
cv::Mat RenderDepth(const Scene& scene);

}  // namespace fovea::scenes
