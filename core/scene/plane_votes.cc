#include "core/scene/plane_votes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr float kOffsetBinM = 0.05F;
constexpr float kMaxBins = 2048;  // on either side
constexpr double kParts = 1e6;
constexpr float kMinCosine = std::numbers::sqrt2_v<float> / 2;

}  // namespace

PlaneVotes::PlaneVotes(const VoxelGrid& grid, const std::vector<int>& voters,
                       const Eigen::Vector3f& up)
    : grid_(grid), x_(up.unitOrthogonal()), y_(up.cross(x_)) {
  for (int i = 0; i < kDirections; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / kDirections;
    directions_[i] = {std::cos(angle), std::sin(angle)};
  }
  float farthest = 0;
  for (const int v : voters) farthest = std::max(farthest, grid.voxels[v].mean.norm());
  bin_m_ = std::max(kOffsetBinM, farthest / kMaxBins);
  num_below_ = static_cast<int>(farthest / bin_m_) + 2;
  votes_.resize(kDirections * (2 * static_cast<std::size_t>(num_below_) + 1));
  LongLoop loop;
  for (const int v : voters) {
    loop.Turn();
    Add(v, 1);
  }
}

void PlaneVotes::Remove(std::span<const int> voters) {
  LongLoop loop;
  for (const int v : voters) {
    loop.Turn();
    Add(v, -1);
  }
}

void PlaneVotes::Add(int voter, double sign) {
  const Voxel& voxel = grid_.voxels[voter];
  const Eigen::Vector2f normal(voxel.normal.dot(x_), voxel.normal.dot(y_));
  const Eigen::Vector2f place(voxel.mean.dot(x_) / bin_m_, voxel.mean.dot(y_) / bin_m_);
  // Whole numbers, so that what is taken back leaves nothing.
  const double size =
      sign * std::round(kParts * voxel.num_points * voxel.mean.z() * voxel.mean.z());
  const std::size_t num_bins = votes_.size() / kDirections;
  for (std::size_t d = 0; d < kDirections; ++d) {
    if (normal.dot(directions_[d]) < kMinCosine) continue;
    const int bin = static_cast<int>(std::floor(place.dot(directions_[d]))) + num_below_;
    votes_[d * num_bins + static_cast<std::size_t>(bin)] += size;
  }
}

std::optional<SupportSurface> PlaneVotes::MostVoted() const {
  const auto fullest = std::max_element(votes_.begin(), votes_.end());
  if (*fullest <= 0) return std::nullopt;
  const auto num_bins = static_cast<std::ptrdiff_t>(votes_.size() / kDirections);
  const std::ptrdiff_t direction = (fullest - votes_.begin()) / num_bins;
  const auto bin = static_cast<float>((fullest - votes_.begin()) % num_bins - num_below_);
  const Eigen::Vector2f& at = directions_[static_cast<std::size_t>(direction)];
  return SupportSurface{at.x() * x_ + at.y() * y_, -(bin + 0.5F) * bin_m_, 0};
}

}  // namespace fovea
