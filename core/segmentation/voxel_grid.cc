#include "core/segmentation/voxel_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unordered_map>

namespace fovea {
namespace {

// 21 bits an axis: ± 10 km at 1 cm, far beyond any depth camera.
std::uint64_t KeyOf(const Eigen::Vector3i& cell) {
  constexpr std::uint64_t kMask = (1U << 21U) - 1;
  const auto part = [](int value) { return static_cast<std::uint64_t>(value + (1 << 20)) & kMask; };
  return part(cell.x()) << 42U | part(cell.y()) << 21U | part(cell.z());
}

struct KeyHash {
  std::size_t operator()(std::uint64_t key) const {
    key *= 0x9E3779B97F4A7C15ULL;  // Fibonacci hashing spreads neighbouring cells
    return key ^ (key >> 32U);
  }
};

using CellIndex = std::unordered_map<std::uint64_t, int, KeyHash>;

// Half of the cells within `reach` that differ along at most `axes` axes, so that each pair is met
// once.
std::vector<Eigen::Vector3i> HalfNeighborhood(int reach, int axes) {
  std::vector<Eigen::Vector3i> offsets;
  for (int x = 0; x <= reach; ++x) {
    for (int y = -reach; y <= reach; ++y) {
      for (int z = -reach; z <= reach; ++z) {
        const bool second_half = x > 0 || y > 0 || (y == 0 && z > 0);
        const int moved = (x != 0) + (y != 0) + (z != 0);
        if (second_half && moved <= axes) offsets.emplace_back(x, y, z);
      }
    }
  }
  return offsets;
}

Eigen::Vector3i CellOf(const Eigen::Vector3f& p, const VoxelOptions& options) {
  const float size = static_cast<float>(options.size_m);
  const Eigen::Vector3f lattice =
      options.perspective ? Eigen::Vector3f(p.x() / p.z(), p.y() / p.z(), std::log(p.z())) : p;
  return (lattice / size).array().floor().cast<int>();
}

// Adds each point to its voxel; means and normals are sums until Finish.
CellIndex CollectVoxels(const cv::Mat& points, const cv::Mat& normals, const VoxelOptions& options,
                        VoxelGrid& grid) {
  CellIndex index;
  int last = -1;  // neighbouring pixels are mostly of the same voxel
  for (int row = 0; row < points.rows; ++row) {
    for (int col = 0; col < points.cols; ++col) {
      const cv::Vec3f& p = points.at<cv::Vec3f>(row, col);
      if (std::isnan(p[2])) continue;
      const Eigen::Vector3f position(p[0], p[1], p[2]);
      const Eigen::Vector3i cell = CellOf(position, options);
      if (last < 0 || grid.voxels[last].cell != cell) {
        const auto [entry, is_new] =
            index.try_emplace(KeyOf(cell), static_cast<int>(grid.voxels.size()));
        if (is_new) grid.voxels.push_back({.cell = cell});
        last = entry->second;
      }
      Voxel& voxel = grid.voxels[last];
      voxel.mean += position;
      const cv::Vec3f& n = normals.at<cv::Vec3f>(row, col);
      if (!std::isnan(n[0])) voxel.normal += Eigen::Vector3f(n[0], n[1], n[2]);
      ++voxel.num_points;
      grid.voxel_of_pixel.at<int>(row, col) = last;
    }
  }
  return index;
}

void Finish(std::vector<Voxel>& voxels) {
  for (Voxel& voxel : voxels) {
    voxel.mean /= static_cast<float>(voxel.num_points);
    const float length = voxel.normal.norm();
    if (length > 1e-3F) voxel.normal /= length;
  }
}

// `index` finds the voxels that take part.
std::vector<VoxelEdge> PairsAt(const std::vector<Eigen::Vector3i>& offsets,
                               const std::vector<Voxel>& voxels, const CellIndex& index) {
  std::vector<VoxelEdge> pairs;
  for (int i = 0; i < static_cast<int>(voxels.size()); ++i) {
    for (const Eigen::Vector3i& offset : offsets) {
      const auto neighbor = index.find(KeyOf(voxels[i].cell + offset));
      if (neighbor == index.end()) continue;
      pairs.push_back({std::min(i, neighbor->second), std::max(i, neighbor->second)});
    }
  }
  return pairs;
}

void SmoothNormals(VoxelGrid& grid) {
  std::vector<Eigen::Vector3f> sums;
  for (const Voxel& voxel : grid.voxels) sums.push_back(voxel.normal);
  for (const VoxelEdge& edge : grid.edges) {
    sums[edge.a] += grid.voxels[edge.b].normal;
    sums[edge.b] += grid.voxels[edge.a].normal;
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const float length = sums[v].norm();
    if (length > 1e-3F) grid.voxels[v].normal = sums[v] / length;
  }
}

}  // namespace

VoxelGrid BuildVoxelGrid(const cv::Mat& points, const cv::Mat& normals,
                         const VoxelOptions& options) {
  VoxelGrid grid;
  grid.voxel_of_pixel = cv::Mat(points.size(), CV_32SC1, cv::Scalar(-1));
  const CellIndex index = CollectVoxels(points, normals, options, grid);
  Finish(grid.voxels);
  grid.edges = PairsAt(HalfNeighborhood(1, options.neighbor_axes), grid.voxels, index);
  for (int pass = 0; pass < options.normal_smoothing; ++pass) SmoothNormals(grid);
  return grid;
}

std::vector<VoxelEdge> PairsWithin(const VoxelGrid& grid, const std::vector<int>& labels,
                                   int reach_cells) {
  std::vector<int> labelled;
  std::vector<Voxel> voxels;
  CellIndex index;
  for (std::size_t v = 0; v < labels.size(); ++v) {
    if (labels[v] == 0) continue;
    index.emplace(KeyOf(grid.voxels[v].cell), static_cast<int>(voxels.size()));
    labelled.push_back(static_cast<int>(v));
    voxels.push_back(grid.voxels[v]);
  }
  std::vector<VoxelEdge> pairs = PairsAt(HalfNeighborhood(reach_cells, 3), voxels, index);
  for (VoxelEdge& pair : pairs) pair = {labelled[pair.a], labelled[pair.b]};
  return pairs;
}

float ConvexityDeg(const Voxel& a, const Voxel& b) {
  const float cosine = std::clamp(a.normal.dot(b.normal), -1.0F, 1.0F);
  const float angle = std::acos(cosine) * 180 / std::numbers::pi_v<float>;
  return (a.normal - b.normal).dot(a.mean - b.mean) >= 0 ? angle : -angle;
}

float StepDeg(const Voxel& a, const Voxel& b) {
  const Eigen::Vector3f normal = a.normal + b.normal;
  const Eigen::Vector3f way = b.mean - a.mean;
  const float lengths = normal.norm() * way.norm();
  if (lengths == 0) return 0;
  const float sine = std::clamp(normal.dot(way) / lengths, -1.0F, 1.0F);
  return std::asin(sine) * 180 / std::numbers::pi_v<float>;
}

}  // namespace fovea
