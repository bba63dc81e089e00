#include "tests/evaluation/peers/euclidean_clusters.h"

#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>

namespace fovea::evaluation {

std::vector<std::uint32_t> EuclideanClusters(const PeerCloud::Ptr& cloud) {
  constexpr double kTolerance_m = 0.005;
  std::vector<std::uint32_t> clusters(cloud->size(), 0);
  if (cloud->empty()) return clusters;
  pcl::EuclideanClusterExtraction<pcl::PointXYZRGBA> extraction;
  extraction.setClusterTolerance(kTolerance_m);
  extraction.setSearchMethod(std::make_shared<pcl::search::KdTree<pcl::PointXYZRGBA>>());
  extraction.setInputCloud(cloud);
  std::vector<pcl::PointIndices> found;
  extraction.extract(found);
  for (std::size_t k = 0; k < found.size(); ++k) {
    for (const int index : found[k].indices) clusters[index] = static_cast<std::uint32_t>(k + 1);
  }
  return clusters;
}

}  // namespace fovea::evaluation
