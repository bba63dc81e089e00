// Votes of voxels for upright planes that they may lie on.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/scene/support_surface.h"
#include "core/segmentation/voxel_grid.h"

namespace fovea {

// Each voxel votes with its size as seen, at the distance where it is seen, in the directions of
// the horizon, every 10°, that lie within 45° of its normal, for the distance along each in which
// it lies, in steps of 5 cm (more where something is farther than 100 m).
class PlaneVotes {
 public:
  // `up`: unit vector. `grid` must outlive it. Cost: some 40 steps a voter.
  PlaneVotes(const VoxelGrid& grid, const std::vector<int>& voters, const Eigen::Vector3f& up);

  // Takes back the votes of voters.
  void Remove(std::span<const int> voters);

  // The plane with most votes.
  std::optional<SupportSurface> MostVoted() const;

 private:
  static constexpr int kDirections = 36;

  void Add(int voter, double sign);

  const VoxelGrid& grid_;
  const Eigen::Vector3f x_, y_;  // of the horizon
  std::array<Eigen::Vector2f, kDirections> directions_;
  float bin_m_ = 0;
  int num_below_ = 0;  // bins of distances below 0, of each direction
  std::vector<double> votes_;
};

}  // namespace fovea
