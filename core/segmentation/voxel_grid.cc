#include "core/segmentation/voxel_grid.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <opencv2/core.hpp>

#include "core/segmentation/cell_index.h"
#include "core/types/interruption.h"
#include "core/types/widest_registers.h"

namespace fovea {
namespace {

constexpr std::size_t kUsualPoints = 8;  // of a voxel, or more

// Half of the neighbouring cells that differ along at most `axes` axes, so that each pair is met
// once.
std::vector<Eigen::Vector3i> HalfNeighborhood(int axes) {
  constexpr std::size_t kMost = 13;
  std::vector<Eigen::Vector3i> offsets;
  offsets.reserve(kMost);
  for (int x = 0; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const bool second_half = x > 0 || y > 0 || (y == 0 && z > 0);
        const int moved = (x != 0) + (y != 0) + (z != 0);
        if (second_half && moved <= axes) offsets.emplace_back(x, y, z);
      }
    }
  }
  return offsets;
}

// The edge of cells. With round intrinsics whole columns and rows of pixels would lie on faces of
// perspective ones (of 0.01 at 525 px every 21st), where rounding decides anew for each pixel.
// Cells smaller by far more than that, and far less than a pixel, decide for all of them alike.
float EdgeOf(const VoxelOptions& options) {
  constexpr double kOffPixels = 1 - 1e-5;
  return static_cast<float>(options.size_m * (options.perspective ? kOffPixels : 1));
}

// The cells of the points of an image row.
class RowCells {
 public:
  RowCells(int cols, const VoxelOptions& options)
      : size_(EdgeOf(options)), perspective_(options.perspective) {
    for (std::vector<float>& places : places_) places.resize(cols);
    for (std::vector<int>& cells : cells_) cells.resize(cols);
  }

  // Cells of pixels without a point mean nothing.
  FOVEA_INLINE void Set(const cv::Vec3f* points) {
    const std::size_t cols = places_[0].size();
    for (std::size_t col = 0; col < cols; ++col) {
      const cv::Vec3f& p = points[col];
      const float scale = perspective_ ? p[2] : 1.0F;
      places_[0][col] = p[0] / scale;
      places_[1][col] = p[1] / scale;
      places_[2][col] = p[2];
    }
    if (perspective_) TakeLogarithms(places_[2]);
    for (std::size_t axis = 0; axis < places_.size(); ++axis) {
      const float* places = places_[axis].data();
      int* cells = cells_[axis].data();
      for (std::size_t col = 0; col < cols; ++col) cells[col] = Floor(places[col] / size_);
    }
  }

  Eigen::Vector3i At(int col) const { return {cells_[0][col], cells_[1][col], cells_[2][col]}; }
  bool AreOne(int a, int b) const {
    return cells_[0][a] == cells_[0][b] && cells_[1][a] == cells_[1][b] &&
           cells_[2][a] == cells_[2][b];
  }

 private:
  // Of positive numbers, for loops that the compiler vectorises: ln(2^e · m) = e ln 2 + 2
  // artanh(s), s = (m - 1) / (m + 1), where m lies between √½ and √2.
  static FOVEA_INLINE void TakeLogarithms(std::vector<float>& values) {
    constexpr auto kRootHalf = std::bit_cast<std::int32_t>(std::numbers::sqrt2_v<float> / 2);
    for (float& value : values) {
      const std::int32_t above = std::bit_cast<std::int32_t>(value) - kRootHalf;
      const std::int32_t exponent = above >> 23;
      const auto m = std::bit_cast<float>((above & 0x7FFFFF) + kRootHalf);
      const float s = (m - 1) / (m + 1), s2 = s * s;
      const float series = 1 + s2 * (1 / 3.0F + s2 * (1 / 5.0F + s2 * (1 / 7.0F + s2 / 9.0F)));
      value = static_cast<float>(exponent) * std::numbers::ln2_v<float> + 2 * s * series;
    }
  }
  // Without a branch, for loops that the compiler vectorises.
  static FOVEA_INLINE int Floor(float value) {
    const int truncated = static_cast<int>(value == value ? value : 0.0F);  // NaN has no int
    return truncated - (static_cast<float>(truncated) > value ? 1 : 0);
  }

  float size_;
  bool perspective_;
  std::array<std::vector<float>, 3> places_;  // x, y, z or x/z, y/z, ln z
  std::array<std::vector<int>, 3> cells_;
};

// Adds the points of the pixels first … end - 1 of a row to a voxel.
void AddPoints(const cv::Vec3f* points, int first, int end, Voxel& voxel) {
  Eigen::Vector3f mean = voxel.mean;
  for (int col = first; col < end; ++col) {
    mean += Eigen::Vector3f(points[col][0], points[col][1], points[col][2]);
  }
  voxel.mean = mean;
  voxel.num_points += end - first;
}

// Adds the normals of those pixels, where they have any; `normals`: of every step-th of the row.
void AddNormals(const cv::Vec3f* normals, int step, int first, int end, Voxel& voxel) {
  Eigen::Vector3f sum = voxel.normal;
  for (int i = step == 1 ? first : (first + step - 1) / step; i * step < end; ++i) {
    const cv::Vec3f& n = normals[i];
    if (!std::isnan(n[0])) sum += Eigen::Vector3f(n[0], n[1], n[2]);
  }
  voxel.normal = sum;
}

// The voxel of a cell: mostly that of the pixel above.
int FindOrAdd(const Eigen::Vector3i& cell, const cv::Point& pixel, int above, CellIndex& index,
              VoxelGrid& grid) {
  if (above >= 0 && grid.voxels[above].cell == cell) return above;
  const int next = static_cast<int>(grid.voxels.size());
  const int voxel = index.FindOrAdd(cell, next);
  if (voxel == next) grid.voxels.push_back({.cell = cell, .first_px = pixel});
  return voxel;
}

// Adds each point to its voxel; means and normals are sums until Finish.
CellIndex CollectVoxels(const cv::Mat& points, const NormalMap& normals,
                        const VoxelOptions& options, VoxelGrid& grid) {
  const std::size_t expected = points.total() / kUsualPoints;
  CellIndex index(expected);
  grid.voxels.reserve(expected);
  RowCells cells(points.cols, options);
  for (int row = 0; row < points.rows; ++row) {
    InterruptionPoint();
    const cv::Vec3f* point = points.ptr<cv::Vec3f>(row);
    int* voxel_of_pixel = grid.voxel_of_pixel.ptr<int>(row);
    const int step = normals.step_px;
    const auto* normals_of_row =
        row % step == 0 ? normals.vectors.ptr<cv::Vec3f>(row / step) : nullptr;
    std::fill_n(voxel_of_pixel, points.cols, -1);
    const int* above = grid.voxel_of_pixel.ptr<int>(std::max(row - 1, 0));
    RunInWidestRegisters([&] { cells.Set(point); });
    for (int first = 0, end = 1; first < points.cols; first = end++) {
      if (std::isnan(point[first][2])) continue;
      while (end < points.cols && !std::isnan(point[end][2]) && cells.AreOne(first, end)) ++end;
      const int voxel = FindOrAdd(cells.At(first), {first, row}, above[first], index, grid);
      AddPoints(point, first, end, grid.voxels[voxel]);
      if (normals_of_row != nullptr) {
        AddNormals(normals_of_row, step, first, end, grid.voxels[voxel]);
      }
      std::fill(voxel_of_pixel + first, voxel_of_pixel + end, voxel);
    }
  }
  return index;
}

void Finish(std::vector<Voxel>& voxels) {
  LongLoop loop;
  for (Voxel& voxel : voxels) {
    loop.Turn();
    voxel.mean /= static_cast<float>(voxel.num_points);
    const float length = voxel.normal.norm();
    if (length > 1e-3F) voxel.normal /= length;
  }
}

std::vector<VoxelEdge> FindNeighbors(const std::vector<Voxel>& voxels, const CellIndex& index,
                                     int axes) {
  const std::vector<Eigen::Vector3i> offsets = HalfNeighborhood(axes);
  std::vector<VoxelEdge> pairs;
  pairs.reserve(voxels.size() * offsets.size());
  LongLoop loop;
  for (int i = 0; i < static_cast<int>(voxels.size()); ++i) {
    loop.Turn();
    for (const Eigen::Vector3i& offset : offsets) {
      const int neighbor = index.Find(voxels[i].cell + offset);
      if (neighbor >= 0) pairs.push_back({std::min(i, neighbor), std::max(i, neighbor)});
    }
  }
  return pairs;
}

void SmoothNormals(VoxelGrid& grid) {
  InterruptionPoint();
  std::vector<Eigen::Vector3f> sums;
  sums.reserve(grid.voxels.size());
  for (const Voxel& voxel : grid.voxels) sums.push_back(voxel.normal);
  LongLoop loop;
  for (const VoxelEdge& edge : grid.edges) {
    loop.Turn();
    sums[edge.a] += grid.voxels[edge.b].normal;
    sums[edge.b] += grid.voxels[edge.a].normal;
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const float length = sums[v].norm();
    if (length > 1e-3F) grid.voxels[v].normal = sums[v] / length;
  }
}

}  // namespace

VoxelGrid BuildVoxelGrid(const cv::Mat& points, const NormalMap& normals,
                         const VoxelOptions& options) {
  VoxelGrid grid;
  grid.voxel_of_pixel.create(points.size(), CV_32SC1);
  const CellIndex index = CollectVoxels(points, normals, options, grid);
  Finish(grid.voxels);
  grid.edges = FindNeighbors(grid.voxels, index, options.neighbor_axes);
  for (int pass = 0; pass < options.normal_smoothing; ++pass) SmoothNormals(grid);
  return grid;
}

std::vector<VoxelEdge> EdgesWithin(const VoxelGrid& grid, const std::vector<char>& values,
                                   char value) {
  std::vector<VoxelEdge> within;
  within.reserve(grid.edges.size());
  InterruptionPoint();
  std::copy_if(
      grid.edges.begin(), grid.edges.end(), std::back_inserter(within),
      [&](const VoxelEdge& edge) { return values[edge.a] == value && values[edge.b] == value; });
  return within;
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
