// Clouds of level and upright surfaces, for tests of what finds supports.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace fovea {

struct Cloud {
  std::vector<cv::Vec3f> points;
  std::vector<cv::Vec3f> normals;

  // A level square of n × n points around (0, y, 1.5); y points down.
  void AddLevel(float y, int n, float tilt = 0) {
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const float x = static_cast<float>(i) / static_cast<float>(n) - 0.5F;
        const float z = static_cast<float>(j) / static_cast<float>(n) + 1.0F;
        points.emplace_back(x, y + tilt * (z - 1.5F), z);
        normals.push_back(cv::normalize(cv::Vec3f(0, -1, tilt)));
      }
    }
  }
  // A level rectangle of one point a centimetre, its corner at (x, z).
  void AddRectangle(float y, float x, float z, int width_cm, int depth_cm) {
    for (int i = 0; i < width_cm; ++i) {
      for (int j = 0; j < depth_cm; ++j) {
        points.emplace_back(x + 0.01F * static_cast<float>(i), y,
                            z + 0.01F * static_cast<float>(j));
        normals.emplace_back(0, -1, 0);
      }
    }
  }
  void AddWall(int n) {
    for (int i = 0; i < n; ++i) {
      points.emplace_back(0.001F * static_cast<float>(i), 0.4F, 2.0F);
      normals.emplace_back(0, 0, -1);
    }
  }
  cv::Mat Points() const { return cv::Mat(points, true).reshape(3, 1); }
  cv::Mat Normals() const { return cv::Mat(normals, true).reshape(3, 1); }
};

}  // namespace fovea
