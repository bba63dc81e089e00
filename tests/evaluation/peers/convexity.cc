#include "tests/evaluation/peers/convexity.h"

#include <pcl/segmentation/cpc_segmentation.h>
#include <pcl/segmentation/lccp_segmentation.h>
#include <pcl/segmentation/supervoxel_clustering.h>

namespace fovea::evaluation {
namespace {

using Point = pcl::PointXYZRGBA;

// Tuned on the mOSD scenes.
constexpr float kVoxel_m = 0.0075F, kSeed_m = 0.03F;
constexpr float kColorWeight = 0, kSpatialWeight = 1, kNormalWeight = 4;
constexpr float kConcavity_deg = 10, kSmoothness = 0.1F;
constexpr std::uint32_t kMinSupervoxels = 12;

void SetConvexity(pcl::LCCPSegmentation<Point>& segmentation) {
  segmentation.setConcavityToleranceThreshold(kConcavity_deg);
  segmentation.setSanityCheck(true);
  segmentation.setSmoothnessCheck(true, kVoxel_m, kSeed_m, kSmoothness);
  segmentation.setMinSegmentSize(kMinSupervoxels);
}

}  // namespace

std::vector<std::uint32_t> ConvexitySegments(const PeerCloud::Ptr& cloud, bool cut_by_planes) {
  std::vector<std::uint32_t> segments(cloud->size(), 0);
  if (cloud->empty()) return segments;
  pcl::SupervoxelClustering<Point> supervoxels(kVoxel_m, kSeed_m);
  supervoxels.setUseSingleCameraTransform(false);
  supervoxels.setInputCloud(cloud);
  supervoxels.setColorImportance(kColorWeight);
  supervoxels.setSpatialImportance(kSpatialWeight);
  supervoxels.setNormalImportance(kNormalWeight);
  std::map<std::uint32_t, pcl::Supervoxel<Point>::Ptr> clusters;
  supervoxels.extract(clusters);
  std::multimap<std::uint32_t, std::uint32_t> adjacency;
  supervoxels.getSupervoxelAdjacency(adjacency);
  const auto labelled = supervoxels.getLabeledCloud();

  std::map<std::uint32_t, std::uint32_t> segment_of;
  const auto run = [&](auto&& segmentation) {
    SetConvexity(segmentation);
    segmentation.setInputSupervoxels(clusters, adjacency);
    segmentation.segment();
    segmentation.getSupervoxelToSegmentMap(segment_of);
  };
  if (cut_by_planes) {
    run(pcl::CPCSegmentation<Point>());  // its own cutting options: smaller cuts score worse
  } else {
    run(pcl::LCCPSegmentation<Point>());
  }
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto found = segment_of.find((*labelled)[i].label);
    if (found != segment_of.end()) segments[i] = found->second;
  }
  return segments;
}

}  // namespace fovea::evaluation
