// An organised cloud in, the points of each object out.
#include <pcl/common/centroid.h>
#include <pcl/io/pcd_io.h>

#include <Eigen/Core>
#include <iostream>
#include <stdexcept>

#include "fovea/client/client.h"
#include "fovea/client/pcl/clouds.h"

int main(int argc, char** argv) try {
  if (argc != 3) throw std::invalid_argument("give HOST:PORT and an organised cloud, FILE.pcd");
  pcl::PointCloud<pcl::PointXYZRGB> cloud;
  if (pcl::io::loadPCDFile(argv[2], cloud) != 0) throw std::runtime_error("that is no PCD file");

  const fovea::client::Client client(argv[1]);
  fovea::v1::DetectRequest request;
  *request.mutable_frame() = fovea::client::ToFrame(cloud, fovea::client::IntrinsicsOf(cloud));
  request.mutable_options()->set_return_masks(true);  // they tell which points are an object's
  const fovea::v1::DetectResponse response = client.Detect(request);
  for (const auto& object : response.detections().objects()) {
    const pcl::PointIndices points = fovea::client::IndicesOf(object, cloud.width);
    Eigen::Vector4f middle;
    const unsigned num_points = pcl::compute3DCentroid(cloud, points, middle);  // with depth
    if (num_points == 0) continue;
    std::cout << object.label() << ": " << num_points << " points around "
              << middle.head<3>().transpose() << " m\n";
  }
} catch (const std::exception& error) {
  std::cerr << "detect_cloud: " << error.what() << '\n';
  return 1;
}
