// Frames and answers from and to the clouds of the Point Cloud Library. A library of its own:
// find_package(fovea COMPONENTS pcl), fovea::pcl. All positions in metres in the camera frame.
#pragma once

#include <pcl/PointIndices.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>

#include "fovea/v1/detection.pb.h"
#include "fovea/v1/frame.pb.h"

namespace fovea::client {

// The pinhole camera that took an organised cloud (pixel (u, v) is point (u, v)), by least squares
// over its points; those without depth (not finite in x, y and z, or z <= 0) are passed over.
// Throws std::invalid_argument where the cloud is not organised, is mirrored, has points with depth
// in fewer than two rows or columns, or more than a pixel away from where such a camera sees them.
// Linear in the number of points.
v1::CameraIntrinsics IntrinsicsOf(const pcl::PointCloud<pcl::PointXYZRGB>& cloud);

// Colour as RGB8 and depth as 32FC1 of an organised cloud; points without depth are NaN. The id is
// empty; the time is the header's (microseconds since 1970), where it is not 0. Throws
// std::invalid_argument where the cloud is not organised or its time is after the year 9999, as one
// in nanoseconds is. Copies, linear in the number of points.
v1::Frame ToFrame(const pcl::PointCloud<pcl::PointXYZRGB>& cloud,
                  const v1::CameraIntrinsics& intrinsics);

// Object.cloud, for which DetectOptions.return_clouds asks; not organised. Throws
// std::runtime_error where positions and colours differ in number.
pcl::PointCloud<pcl::PointXYZRGB> ToPcl(const v1::PointCloud& cloud);

// The pixels of the object's mask, for which DetectOptions.return_masks asks, as indices into the
// organised cloud of the frame, which has `width` columns: for pcl::ExtractIndices and all that
// takes indices. Throws std::invalid_argument for an object without a mask, std::exception for a
// broken mask, or one that reaches beyond `width`.
pcl::PointIndices IndicesOf(const v1::Object& object, std::uint32_t width);

// The frame's cloud with the labels of its objects, 0 = none. It needs masks, too: throws
// std::invalid_argument where an object has none, std::exception where the cloud is not of the
// answer's size, or a mask is broken or beyond it.
pcl::PointCloud<pcl::PointXYZRGBL> Labelled(const pcl::PointCloud<pcl::PointXYZRGB>& cloud,
                                            const v1::Detections& detections);

Eigen::Isometry3d ToEigen(const v1::Pose& pose);

}  // namespace fovea::client
