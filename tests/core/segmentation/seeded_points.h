// A few points in voxels, some seeds, and what the data term says of them as printed.
#pragma once

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <random>
#include <vector>

#include "core/segmentation/data_term.h"

namespace fovea {

struct SeededPoints {
  cv::Mat points = cv::Mat(12, 12, CV_32FC3);
  VoxelGrid grid;
  std::vector<Seed> seeds;
};

inline SeededPoints RandomPoints(unsigned seed, double voxel_m = 0.05) {
  SeededPoints scene;
  std::mt19937 random(seed);
  const auto uniform = [&] { return static_cast<float>(random() % 1001) / 1000.0F; };
  for (auto it = scene.points.begin<cv::Vec3f>(); it != scene.points.end<cv::Vec3f>(); ++it) {
    *it = {0.1F * uniform(), 0.1F * uniform(), 1 + 0.1F * uniform()};
  }
  const cv::Mat normals(scene.points.size(), CV_32FC3, cv::Scalar(0, 0, -1));
  scene.grid = BuildVoxelGrid(scene.points, {normals}, {.size_m = voxel_m});
  for (int i = 0; i < 3; ++i) {
    scene.seeds.push_back({{}, {0.1F * uniform(), 0.1F * uniform(), 1.0F}});
  }
  return scene;
}

// Each voxel as a site.
inline Sites SitesOf(const SeededPoints& scene) {
  const std::size_t count = scene.grid.voxels.size();
  Sites sites{{}, std::vector<float>(count, 0), std::vector<float>(count, 1)};
  for (const Voxel& voxel : scene.grid.voxels) sites.means.push_back(voxel.mean);
  for (int i = 0; i < static_cast<int>(scene.points.total()); ++i) {
    const auto& p = scene.points.at<cv::Vec3f>(i / scene.points.cols, i % scene.points.cols);
    const int v = scene.grid.voxel_of_pixel.at<int>(i / scene.points.cols, i % scene.points.cols);
    const Voxel& voxel = scene.grid.voxels[v];
    sites.variances_m2[v] += (Eigen::Vector3f(p[0], p[1], p[2]) - voxel.mean).squaredNorm() /
                             static_cast<float>(voxel.num_points);
  }
  return sites;
}

// Eq. 2 as printed: the mean over the voxel's points of −ln p(label | x).
inline double LiteralCost(const SeededPoints& scene, int voxel, int label,
                          const DataTermOptions& options) {
  double sum = 0;
  int count = 0;
  for (int row = 0; row < scene.points.rows; ++row) {
    for (int col = 0; col < scene.points.cols; ++col) {
      if (scene.grid.voxel_of_pixel.at<int>(row, col) != voxel) continue;
      const cv::Vec3f& p = scene.points.at<cv::Vec3f>(row, col);
      const auto probability = [&](int c) {  // Eq. 5
        const Eigen::Vector3d d =
            Eigen::Vector3d(p[0], p[1], p[2]) - scene.seeds[c].position.cast<double>();
        return std::exp(-options.gamma_per_m2 * d.squaredNorm());
      };
      double value = 0;
      if (label > 0) {
        value = probability(label - 1);
      } else {  // Eq. 6
        double least = 1;
        for (int c = 0; c < 3; ++c) least = std::min(least, 1 - probability(c));
        value = options.alpha * std::max(least, options.min_probability);
      }
      sum -= std::log(value);
      ++count;
    }
  }
  return sum / count;
}

}  // namespace fovea
