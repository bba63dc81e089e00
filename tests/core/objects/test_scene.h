// A scene for tests of what surrounds segments: a level camera, a pixel is a centimetre at 1 m.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "core/objects/labelled_scene.h"

namespace fovea {

struct TestScene {
  explicit TestScene(float background_m)
      : points(120, 200, CV_32FC3), lab(120, 200, CV_8UC3, cv::Scalar(108, 128, 128)) {
    labels = cv::Mat::zeros(120, 200, CV_16UC1);
    Put({0, 0, 200, 120}, background_m, 0);
  }

  // A facing rectangle at a distance (NaN: not measured).
  void Put(const cv::Rect& rectangle, float z_m, int label) {
    for (int row = rectangle.y; row < rectangle.br().y; ++row) {
      for (int col = rectangle.x; col < rectangle.br().x; ++col) {
        points.at<cv::Vec3f>(row, col) = {static_cast<float>(col - 100) * z_m / 100,
                                          static_cast<float>(row - 60) * z_m / 100, z_m};
      }
    }
    labels(rectangle).setTo(label);
  }

  // With one voxel a pixel, on a wall where `wall` says so.
  LabelledScene Labelled() {
    grid.voxels.clear();
    grid.voxel_of_pixel = cv::Mat(labels.size(), CV_32SC1, cv::Scalar(-1));
    segments.clear();
    on_wall.clear();
    for (int row = 0; row < labels.rows; ++row) {
      for (int col = 0; col < labels.cols; ++col) {
        const cv::Vec3f& p = points.at<cv::Vec3f>(row, col);
        if (p[2] != p[2]) continue;
        grid.voxel_of_pixel.at<int>(row, col) = static_cast<int>(grid.voxels.size());
        grid.voxels.push_back({.cell = {col, row, 0},
                               .mean = {p[0], p[1], p[2]},
                               .normal = -Eigen::Vector3f::UnitZ(),
                               .num_points = 1});
        segments.push_back(labels.at<std::uint16_t>(row, col));
        on_wall.push_back(segments.back() == 0 && wall.contains({col, row}) ? 1 : 0);
      }
    }
    colors.assign(grid.voxels.size(), {});
    if (standing.empty()) standing = cv::Mat::zeros(labels.size(), CV_8UC1);
    return {grid,     segments, points,  lab,   colors, intrinsics, {0.0F, -1.0F, 0.0F},
            supports, standing, on_wall, unseen};
  }

  cv::Mat points, lab, labels, standing, unseen;
  cv::Rect wall;
  CameraIntrinsics intrinsics{100, 100, 100, 60};
  VoxelGrid grid;
  std::vector<int> segments;
  std::vector<MeanColor> colors;
  std::vector<Support> supports;
  std::vector<char> on_wall;
};

}  // namespace fovea
