#include "core/segmentation/voxel_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>

#include "core/segmentation/cell_index.h"

namespace fovea {
namespace {

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

// The cells of the lattice, for points of which many in a row have the same depth.
class Lattice {
 public:
  explicit Lattice(const VoxelOptions& options)
      : size_(static_cast<float>(options.size_m)), perspective_(options.perspective) {}

  Eigen::Vector3i CellOf(const Eigen::Vector3f& p) {
    const Eigen::Vector3f place =
        perspective_ ? Eigen::Vector3f(p.x() / p.z(), p.y() / p.z(), LogOf(p.z())) : p;
    return {cvFloor(place.x() / size_), cvFloor(place.y() / size_), cvFloor(place.z() / size_)};
  }

 private:
  float LogOf(float z) {
    if (z != last_z_) last_log_ = std::log(z);
    last_z_ = z;
    return last_log_;
  }

  float size_;
  bool perspective_;
  float last_z_ = 1;
  float last_log_ = 0;
};

// Adds each point to its voxel; means and normals are sums until Finish.
CellIndex CollectVoxels(const cv::Mat& points, const cv::Mat& normals, const VoxelOptions& options,
                        VoxelGrid& grid) {
  CellIndex index(points.total() / 16);
  Lattice lattice(options);
  int last = -1;  // neighbouring pixels are mostly of the same voxel
  for (int row = 0; row < points.rows; ++row) {
    const cv::Vec3f* point = points.ptr<cv::Vec3f>(row);
    const cv::Vec3f* normal = normals.ptr<cv::Vec3f>(row);
    int* voxel_of_pixel = grid.voxel_of_pixel.ptr<int>(row);
    for (int col = 0; col < points.cols; ++col) {
      const cv::Vec3f& p = point[col];
      if (std::isnan(p[2])) continue;
      const Eigen::Vector3f position(p[0], p[1], p[2]);
      const Eigen::Vector3i cell = lattice.CellOf(position);
      if (last < 0 || grid.voxels[last].cell != cell) {
        const int next = static_cast<int>(grid.voxels.size());
        last = index.FindOrAdd(cell, next);
        if (last == next) grid.voxels.push_back({.cell = cell});
      }
      Voxel& voxel = grid.voxels[last];
      voxel.mean += position;
      const cv::Vec3f& n = normal[col];
      if (!std::isnan(n[0])) voxel.normal += Eigen::Vector3f(n[0], n[1], n[2]);
      ++voxel.num_points;
      voxel_of_pixel[col] = last;
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
      const int neighbor = index.Find(voxels[i].cell + offset);
      if (neighbor >= 0) pairs.push_back({std::min(i, neighbor), std::max(i, neighbor)});
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
    index.FindOrAdd(grid.voxels[v].cell, static_cast<int>(voxels.size()));
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
