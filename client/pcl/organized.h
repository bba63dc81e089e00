// Of clouds that are organised as images.
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace fovea::client {

// Throws std::invalid_argument unless the cloud has rows and columns.
void RequireOrganized(const pcl::PointCloud<pcl::PointXYZRGB>& cloud);

// Whether the camera measured it: finite in x, y and z, and before the camera.
bool HasDepth(const pcl::PointXYZRGB& point);

}  // namespace fovea::client
