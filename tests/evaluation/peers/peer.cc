#include "tests/evaluation/peers/peer.h"

#include <pcl/console/print.h>

#include <mutex>
#include <stdexcept>

#include "tests/evaluation/peers/convexity.h"
#include "tests/evaluation/peers/euclidean_clusters.h"
#include "tests/evaluation/peers/table_removal.h"

namespace fovea::evaluation {

std::vector<std::string> PeerNames() { return {"lccp", "cpc", "plane_clusters"}; }

cv::Mat SegmentWithPeer(const std::string& name, const RgbdFrame& frame) {
  constexpr int kMinPixels = 1500;
  static std::once_flag quiet;  // CPC reports every cut
  std::call_once(quiet, [] { pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); });
  const PixelCloud cloud = CloudAboveTable(frame, {});
  const cv::Size size = frame.depth_m.size();
  if (name == "lccp") {
    return LabelsOfPoints(cloud, ConvexitySegments(cloud.points, false), size, kMinPixels);
  }
  if (name == "cpc") {
    return LabelsOfPoints(cloud, ConvexitySegments(cloud.points, true), size, kMinPixels);
  }
  if (name == "plane_clusters") {
    return LabelsOfPoints(cloud, EuclideanClusters(cloud.points), size, kMinPixels);
  }
  throw std::invalid_argument("peer: \"" + name + "\" is unknown");
}

}  // namespace fovea::evaluation
