// What the peers have in common: points without the table before, a label image after.
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/types/rgbd_frame.h"

namespace fovea::evaluation {

using PeerCloud = pcl::PointCloud<pcl::PointXYZRGBA>;

struct TableRemovalOptions {
  double tolerance_m = 0.005;  // of points of the plane
  int iterations = 500;        // of RANSAC, with PCL's fixed seed
  float min_height_m = 0.005;  // lower points are dropped
};

struct PixelCloud {
  PeerCloud::Ptr points;          // in the camera frame, metres
  std::vector<cv::Point> pixels;  // of each point
};

// The measured points above the plane with the most points; all of them where there is no plane.
// "Above" is the side of the camera.
PixelCloud CloudAboveTable(const RgbdFrame& frame, const TableRemovalOptions& options);

// Writes the segment of each point (0 = none) to its pixel, without segments below `min_pixels`,
// numbered from 1. CV_16UC1.
cv::Mat LabelsOfPoints(const PixelCloud& cloud, const std::vector<std::uint32_t>& segments,
                       const cv::Size& size, int min_pixels);

}  // namespace fovea::evaluation
