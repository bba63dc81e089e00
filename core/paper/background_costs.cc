#include "core/paper/background_costs.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "core/segmentation/foreground.h"
#include "core/segmentation/neighborhoods.h"
#include "core/segmentation/points_of_voxels.h"
#include "core/types/interruption.h"

namespace fovea::paper {
namespace {

// Some seeds for each voxel, in one list.
class SeedsOfVoxels {
 public:
  explicit SeedsOfVoxels(std::size_t num_voxels) : range_of_voxel_(num_voxels) {}

  std::span<const Eigen::Vector3f> Of(int voxel) const {
    const Range& range = range_of_voxel_[voxel];
    return std::span(seeds_).subspan(range.first, range.count);
  }
  // Once for each voxel: the seeds that may be the nearest to a point of it, which is not farther
  // from its mean than `radius`. By the triangle inequality those not farther from the mean than
  // the nearest one is, plus twice the radius.
  void AddNearest(int v, const Voxel& voxel, float radius, Positions& seeds) {
    if (seeds.size() == 0) return;
    const std::vector<float>& squared_distances = seeds.SquaredDistances(voxel.mean);
    // A little more for rounding, also where the voxel is a single point.
    const float limit = 1.00001F * std::sqrt(std::ranges::min(squared_distances)) + 2.01F * radius;
    const std::size_t first = seeds_.size();
    for (std::size_t i = 0; i < seeds.size(); ++i) {
      if (squared_distances[i] <= limit * limit) seeds_.push_back(seeds.At(i));
    }
    range_of_voxel_[v] = {first, seeds_.size() - first};
  }

 private:
  struct Range {
    std::size_t first = 0, count = 0;
  };

  std::vector<Eigen::Vector3f> seeds_;
  std::vector<Range> range_of_voxel_;
};

// The nearest ones of each voxel, without those from which no point of it is within `reach_m`.
SeedsOfVoxels FindNearSeeds(const VoxelGrid& grid, const Foreground& foreground,
                            const std::vector<float>& squared_radius,
                            const std::vector<Seed>& seeds, float reach_m) {
  SeedsOfVoxels near_seeds(grid.voxels.size());
  if (foreground.voxels.empty()) return near_seeds;
  const std::vector<Eigen::Vector3f> positions = PositionsOf(seeds);
  const float max_radius = std::sqrt(std::ranges::max(squared_radius));
  Positions around;
  LongLoop loop;
  ForEachNeighborhood(foreground.means, positions, reach_m + max_radius,
                      [&](const std::vector<int>& members, const std::vector<int>& near) {
                        around.Choose(positions, near);
                        for (const int i : members) {
                          loop.Turn();
                          const int v = foreground.voxels[i];
                          near_seeds.AddNearest(v, grid.voxels[v], std::sqrt(squared_radius[v]),
                                                around);
                        }
                      });
  return near_seeds;
}

// From where on Eq. 5 leaves nothing of Eq. 6: less than half of the last bit of one.
float BackgroundReach(const DataTermOptions& options) {
  return static_cast<float>(std::sqrt(38 / options.gamma_per_m2));
}

}  // namespace

std::vector<float> BackgroundCosts(const VoxelGrid& grid, const cv::Mat& points,
                                   const std::vector<char>& is_background,
                                   const cv::Mat& on_support, const std::vector<Seed>& seeds,
                                   const DataTermOptions& options) {
  std::vector<float> squared_radius(grid.voxels.size()), costs(grid.voxels.size());
  ForEachPoint(grid, points, is_background, [&](int v, const Eigen::Vector3f& x, cv::Point) {
    const float squared_distance = (x - grid.voxels[v].mean).squaredNorm();
    squared_radius[v] = std::max(squared_radius[v], squared_distance);
  });

  const SeedsOfVoxels near_seeds = FindNearSeeds(grid, CollectForeground(grid, is_background),
                                                 squared_radius, seeds, BackgroundReach(options));
  ForEachPoint(grid, points, is_background, [&](int v, const Eigen::Vector3f& x, cv::Point at) {
    if (!on_support.empty() && on_support.at<std::uint8_t>(at) != 0) return;  // -ln 1
    float nearest = std::numeric_limits<float>::infinity();
    for (const Eigen::Vector3f& seed : near_seeds.Of(v)) {
      nearest = std::min(nearest, (x - seed).squaredNorm());
    }
    const float share = 1.0F / static_cast<float>(grid.voxels[v].num_points);
    costs[v] += share * BackgroundCost(nearest, options);
  });
  return costs;
}

}  // namespace fovea::paper
