#include "core/types/blocks.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace fovea {
namespace {

constexpr float kFarthest = std::numeric_limits<float>::infinity();

int NumBlocks(int size, int block) { return (size + block - 1) / block; }

// NaN is never nearer.
void TakeNearer(const float* depths, std::vector<float>& nearest) {
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    nearest[i] = depths[i] < nearest[i] ? depths[i] : nearest[i];
  }
}

// NaN where none is.
float MeanOfMeasured(const cv::Mat& depth_m, const cv::Range& rows, const cv::Range& cols) {
  float sum = 0, count = 0;
  for (int row = rows.start; row < rows.end; ++row) {
    const float* depth = depth_m.ptr<float>(row);
    for (int col = cols.start; col < cols.end; ++col) {
      const bool is_measured = (depth[col] > 0) & (depth[col] < kFarthest);
      sum += is_measured ? depth[col] : 0.0F;
      count += is_measured ? 1.0F : 0.0F;
    }
  }
  return sum / count;
}

template <typename T>
void Enlarge(const cv::Mat& map, int size_px, cv::Mat& enlarged) {
  for (int row = 0; row < enlarged.rows; row += size_px) {
    const T* value = map.ptr<T>(row / size_px);
    T* first = enlarged.ptr<T>(row);
    for (int col = 0; col < enlarged.cols; col += size_px, ++value) {
      std::fill_n(first + col, std::min(size_px, enlarged.cols - col), *value);
    }
    const int end_row = std::min(row + size_px, enlarged.rows);
    for (int copy = row + 1; copy < end_row; ++copy) {
      std::copy_n(first, enlarged.cols, enlarged.ptr<T>(copy));
    }
  }
}

}  // namespace

cv::Mat ReduceByBlocks(const cv::Mat& image, int size_px) {
  if (size_px == 1) return image;
  const cv::Size blocks(NumBlocks(image.cols, size_px), NumBlocks(image.rows, size_px));
  cv::Mat padded = image, reduced;
  if (const cv::Size whole = blocks * size_px; whole != image.size()) {
    cv::copyMakeBorder(image, padded, 0, whole.height - image.rows, 0, whole.width - image.cols,
                       cv::BORDER_REPLICATE);
  }
  cv::resize(padded, reduced, blocks, 0, 0, cv::INTER_AREA);
  return reduced;
}

cv::Mat ReduceDepthByBlocks(const cv::Mat& depth_m, int size_px) {
  if (size_px == 1) return depth_m;
  const int cols = NumBlocks(depth_m.cols, size_px);
  cv::Mat reduced(NumBlocks(depth_m.rows, size_px), cols, CV_32FC1);
  for (int block_row = 0; block_row < reduced.rows; ++block_row) {
    const cv::Range rows(block_row * size_px, std::min((block_row + 1) * size_px, depth_m.rows));
    float* mean = reduced.ptr<float>(block_row);
    for (int block = 0; block < cols; ++block) {
      const int first = block * size_px, end = std::min(first + size_px, depth_m.cols);
      mean[block] = MeanOfMeasured(depth_m, rows, {first, end});
    }
  }
  return reduced;
}

cv::Mat NearestOfBlocks(const cv::Mat& depth_m, int size_px) {
  if (size_px == 1) return depth_m;
  const int cols = NumBlocks(depth_m.cols, size_px);
  cv::Mat reduced(NumBlocks(depth_m.rows, size_px), cols, CV_32FC1);
  std::vector<float> of_columns(depth_m.cols);
  for (int block_row = 0; block_row < reduced.rows; ++block_row) {
    std::fill(of_columns.begin(), of_columns.end(), kFarthest);
    const int end_row = std::min((block_row + 1) * size_px, depth_m.rows);
    for (int row = block_row * size_px; row < end_row; ++row) {
      TakeNearer(depth_m.ptr<float>(row), of_columns);
    }
    float* nearest = reduced.ptr<float>(block_row);
    for (int block = 0; block < cols; ++block) {
      const int first = block * size_px, end = std::min(first + size_px, depth_m.cols);
      float depth = kFarthest;
      for (int col = first; col < end; ++col) depth = std::min(depth, of_columns[col]);
      nearest[block] = depth < kFarthest ? depth : std::numeric_limits<float>::quiet_NaN();
    }
  }
  return reduced;
}

cv::Mat EnlargeBlocks(const cv::Mat& map, int size_px, const cv::Size& size) {
  if (size_px == 1) return map;
  cv::Mat enlarged(size, map.type());
  switch (map.type()) {
    case CV_8UC1:
      Enlarge<std::uint8_t>(map, size_px, enlarged);
      break;
    case CV_32SC1:
      Enlarge<std::int32_t>(map, size_px, enlarged);
      break;
    default:
      CV_Assert(map.type() == CV_32FC1);
      Enlarge<float>(map, size_px, enlarged);
  }
  return enlarged;
}

}  // namespace fovea
