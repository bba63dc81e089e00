// Simple things on a floor before an ideal camera, with their true masks.
#pragma once

#include <numbers>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/depth/back_projection.h"
#include "core/objects/oriented_box.h"
#include "core/shape/complete_objects.h"
#include "tests/support/labelled_frame.h"
#include "tests/support/random_objects.h"

namespace fovea {

struct ThingsOnFloor {
  RgbdFrame frame;
  cv::Mat points;         // CV_32FC3
  Detections detections;  // thing k at k - 1, with its shape and box
};

inline scenes::Body Thing(scenes::ShapeKind kind, const Eigen::Vector3d& size_m,
                          const Eigen::Vector2d& at, double on_m, double yaw_rad = 0,
                          double wall_m = 0) {
  scenes::Body body;
  body.name = "thing";
  body.shape = {kind, size_m, wall_m, {}};
  body.material.color = {0.5, 0.1, 0.1};
  body.is_object = true;
  scenes::Rest(body, at, on_m, yaw_rad);
  return body;
}

// On a floor, seen from 0.9 m away and this high up.
inline ThingsOnFloor CompleteThings(const std::vector<scenes::Body>& things, double pitch_deg) {
  scenes::Scene scene;
  scenes::Body floor = Thing(scenes::ShapeKind::kBox, {4, 4, 0.1}, {0, 0}, -0.1);
  floor.is_object = false;
  floor.material.color = {0.6, 0.6, 0.6};
  scene.bodies = {floor};
  scene.bodies.insert(scene.bodies.end(), things.begin(), things.end());
  scene.camera.world_from_camera =
      scenes::LookAt({0, 0, 0.05}, 0.9, pitch_deg * std::numbers::pi / 180, 0, 0);
  scene.supports = {{0, {0, 0}, {2, 2}}};
  const scenes::LabelledFrame labelled = MakeFrame(scene, scenes::SensorKind::kIdeal, 1);

  ThingsOnFloor result;
  result.frame = labelled.frame;
  Detections& detections = result.detections;
  detections.gravity.direction = labelled.gravity;
  detections.labels = labelled.labels;
  result.points = BackProject(labelled.frame.depth_m, labelled.frame.intrinsics, 10);
  const cv::Mat& points = result.points;
  const SupportSurface& support = labelled.supports.front();
  for (std::size_t i = 0; i < things.size(); ++i) {
    DetectedObject& object = detections.objects.emplace_back();
    object.label = static_cast<int>(i) + 1;
    std::vector<Eigen::Vector3f> positions;
    std::vector<cv::Point> pixels;
    cv::findNonZero(labelled.labels == object.label, pixels);
    for (const cv::Point& pixel : pixels) {
      const cv::Vec3f& p = points.at<cv::Vec3f>(pixel);
      object.cloud.push_back({p[0], p[1], p[2]});
      positions.emplace_back(p[0], p[1], p[2]);
      object.centroid += positions.back() / static_cast<float>(pixels.size());
    }
    object.bounds_px = cv::boundingRect(pixels);
    object.visible_box = FitOrientedBox(positions, support.normal, support);
    object.box = object.visible_box;
  }
  CompleteObjects(labelled.frame, {labelled.frame.depth_m, labelled.frame.intrinsics},
                  std::vector<std::optional<SupportSurface>>(things.size(), support), detections);
  return result;
}

}  // namespace fovea
