#include "core/paper/superpixels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/types/interruption.h"

namespace fovea::paper {
namespace {

constexpr int kIterations = 5;  // Achanta et al.: 10; from a grid, hardly a pixel moves after 5

struct Grid {
  int cols = 1;
  int rows = 1;
  float cell_px = 1;

  Grid(cv::Size size, int count) {
    cell_px = static_cast<float>(std::sqrt(static_cast<double>(size.area()) / count));
    cols = std::max(1, static_cast<int>(std::lround(static_cast<float>(size.width) / cell_px)));
    rows = std::max(1, static_cast<int>(std::lround(static_cast<float>(size.height) / cell_px)));
  }
};

// The index of the cell that a pixel lies in, along one axis.
int CellOf(int pixel, int size, int count) {
  return static_cast<int>(std::int64_t{pixel} * count / size);
}

cv::Mat LabelByCell(const cv::Mat& map, const Grid& grid) {
  cv::Mat labels(map.size(), CV_32S);
  for (int y = 0; y < map.rows; ++y) {
    InterruptionPoint();
    const int row = CellOf(y, map.rows, grid.rows);
    for (int x = 0; x < map.cols; ++x) {
      const int cell = row * grid.cols + CellOf(x, map.cols, grid.cols);
      labels.at<int>(y, x) = std::isfinite(map.at<float>(y, x)) ? cell : -1;
    }
  }
  return labels;
}

// Means over the pixels of each label; a superpixel that lost all its pixels stays empty.
std::vector<Superpixel> Average(const cv::Mat& map, const cv::Mat& labels, const Grid& grid) {
  struct Sum {
    double x = 0, y = 0, value = 0;
    int pixels = 0;
  };
  std::vector<Sum> sums(static_cast<std::size_t>(grid.cols * grid.rows));
  for (int y = 0; y < map.rows; ++y) {
    InterruptionPoint();
    for (int x = 0; x < map.cols; ++x) {
      const int label = labels.at<int>(y, x);
      if (label < 0) continue;
      Sum& sum = sums[static_cast<std::size_t>(label)];
      sum.x += x;
      sum.y += y;
      sum.value += map.at<float>(y, x);
      ++sum.pixels;
    }
  }
  InterruptionPoint();
  std::vector<Superpixel> all(sums.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Sum& sum = sums[i];
    if (sum.pixels == 0) continue;
    all[i] = {static_cast<float>(sum.x / sum.pixels), static_cast<float>(sum.y / sum.pixels),
              static_cast<float>(sum.value / sum.pixels), sum.pixels};
  }
  return all;
}

// Lets the pixels of one grid cell choose anew among the superpixels of the 3×3 cells about it.
void AssignCell(const cv::Mat& map, const Grid& grid, cv::Point cell, float px_weight,
                Superpixels& superpixels) {
  const auto begin_of = [](int index, int size, int count) {
    return static_cast<int>((std::int64_t{index} * size + count - 1) / count);
  };
  const int first_x = begin_of(cell.x, map.cols, grid.cols);
  const int end_x = begin_of(cell.x + 1, map.cols, grid.cols);
  const int end_y = begin_of(cell.y + 1, map.rows, grid.rows);
  std::vector<float> least(static_cast<std::size_t>(end_x - first_x));
  for (int y = begin_of(cell.y, map.rows, grid.rows); y < end_y; ++y) {
    const float* values = map.ptr<float>(y) + first_x;
    int* labels = superpixels.labels.ptr<int>(y) + first_x;
    std::fill(least.begin(), least.end(), std::numeric_limits<float>::infinity());
    for (int row = std::max(cell.y - 1, 0); row <= std::min(cell.y + 1, grid.rows - 1); ++row) {
      for (int col = std::max(cell.x - 1, 0); col <= std::min(cell.x + 1, grid.cols - 1); ++col) {
        const int candidate = row * grid.cols + col;
        const Superpixel& center = superpixels.all[static_cast<std::size_t>(candidate)];
        if (center.pixels == 0) continue;
        const float dy = static_cast<float>(y) - center.y_px;
        const float dx = static_cast<float>(first_x) - center.x_px;
        for (int i = 0; i < end_x - first_x; ++i) {
          const float across = dx + static_cast<float>(i);
          const float off = values[i] - center.value;
          const float distance = off * off + px_weight * (across * across + dy * dy);
          float& best = least[static_cast<std::size_t>(i)];
          labels[i] = distance < best ? candidate : labels[i];  // never where there is no value
          best = distance < best ? distance : best;
        }
      }
    }
  }
}

}  // namespace

Superpixels DivideIntoSuperpixels(const cv::Mat& map, int count, float compactness) {
  const Grid grid(map.size(), count);
  const float px_weight = compactness * compactness / (grid.cell_px * grid.cell_px);
  Superpixels superpixels{LabelByCell(map, grid), {}};
  superpixels.all = Average(map, superpixels.labels, grid);
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    for (int row = 0; row < grid.rows; ++row) {
      InterruptionPoint();
      for (int col = 0; col < grid.cols; ++col) {
        AssignCell(map, grid, {col, row}, px_weight, superpixels);
      }
    }
    superpixels.all = Average(map, superpixels.labels, grid);
  }
  return superpixels;
}

}  // namespace fovea::paper
