// PropagateStrength: Eq. 3 and 4 iterated to their fixed point.
//
// A strength is the best product of factors along any path from the border. Every factor lies in
// [0, 1] and rounded multiplication is monotone, so the strengths only grow from 0 and end in the
// same bits whatever the order of the updates. That freedom buys the speed: alternating sweeps
// down and up the image carry a strength along a whole path at once, and a sweep leaves out the
// blocks of pixels none of whose neighbours grew since they were last looked at.
#include <algorithm>
#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <utility>
#include <vector>

#include "core/saliency/strength_saliency.h"

namespace fovea {
namespace {

constexpr int kBlock_px = 16;  // one SIMD register of 8-bit features

// Eq. 3 without the neighbour's strength.
float Factor(std::uint8_t a, std::uint8_t b) {
  const auto difference = static_cast<std::uint8_t>(std::max(a, b) - std::min(a, b));
  return 1.0F - static_cast<float>(difference) / 255.0F;
}

// Where sweeps in one direction still have to look: blocks with a grown neighbour.
class PendingBlocks {
 public:
  PendingBlocks(int rows, int blocks)
      : blocks_(cv::Mat::ones(rows, blocks + 2, CV_8U)), rows_(static_cast<std::size_t>(rows), 1) {}

  // Blocks -1 and the one past the last may be marked and are never taken.
  void Mark(int row, int first, int last) {
    std::uint8_t* flags = blocks_.ptr<std::uint8_t>(row) + 1;
    std::fill(flags + first, flags + last + 1, std::uint8_t{1});
    rows_[static_cast<std::size_t>(row)] = 1;
  }
  bool TakeRow(int row) { return std::exchange(rows_[static_cast<std::size_t>(row)], 0) != 0; }
  bool TakeBlock(int row, int block) {
    return std::exchange(blocks_.ptr<std::uint8_t>(row)[block + 1], std::uint8_t{0}) != 0;
  }

 private:
  cv::Mat blocks_;
  std::vector<char> rows_;
};

class Propagation {
 public:
  Propagation(const cv::Mat& channel, int scale)
      : scale_(scale),
        rows_(channel.rows),
        blocks_((channel.cols - 2 * scale + kBlock_px - 1) / kBlock_px),
        down_(rows_, blocks_),
        up_(rows_, blocks_) {
    // Blocks are whole: columns past the image are border, which nothing inside looks at.
    const int cols = blocks_ * kBlock_px + 2 * scale;
    cv::copyMakeBorder(channel, features_, 0, 0, 0, cols - channel.cols, cv::BORDER_REPLICATE);
    strengths_ = cv::Mat::ones(rows_, cols, CV_32F);
    const cv::Rect inside(scale, scale, channel.cols - 2 * scale, rows_ - 2 * scale);
    strengths_(inside) = 0.0F;
  }

  cv::Mat Run() {
    while (SweepDown() | SweepUp()) continue;
    return strengths_;
  }

 private:
  // Each sweep lets every pending block pull from the half of its ring that the sweep has passed.
  // Returns whether any strength grew.
  bool SweepDown() {
    bool grew = false;
    for (int y = scale_; y < rows_ - scale_; ++y) {
      if (!down_.TakeRow(y)) continue;
      for (int block = 0; block < blocks_; ++block) {
        if (down_.TakeBlock(y, block) && Pull<-1>(y, block)) {
          MarkNeighbours(y, block);
          down_.Mark(y, block + 1, block + 1);
          up_.Mark(y, block - 1, block);
          grew = true;
        }
      }
    }
    return grew;
  }

  bool SweepUp() {
    bool grew = false;
    for (int y = rows_ - scale_ - 1; y >= scale_; --y) {
      if (!up_.TakeRow(y)) continue;
      for (int block = blocks_ - 1; block >= 0; --block) {
        if (up_.TakeBlock(y, block) && Pull<+1>(y, block)) {
          MarkNeighbours(y, block);
          up_.Mark(y, block - 1, block - 1);
          down_.Mark(y, block, block + 1);
          grew = true;
        }
      }
    }
    return grew;
  }

  void MarkNeighbours(int y, int block) {
    for (int step = 1; step <= scale_; ++step) {
      if (y + step < rows_ - scale_) down_.Mark(y + step, block - 1, block + 1);
      if (y - step >= scale_) up_.Mark(y - step, block - 1, block + 1);
    }
  }

  // Eq. 4 for one block over the half ring above (side = -1) or below (+1), the same row last.
  template <int side>
  bool Pull(int y, int block) {
    const int x = scale_ + block * kBlock_px;
    const std::uint8_t* features = features_.ptr<std::uint8_t>(y) + x;
    float* strengths = strengths_.ptr<float>(y) + x;
    std::array<float, kBlock_px> best;
    std::copy_n(strengths, kBlock_px, best.begin());
    for (int step = 1; step < scale_; ++step) {
      PullFrom(features, y + side * step, x - scale_, best);
      PullFrom(features, y + side * step, x + scale_, best);
    }
    for (int shift = -scale_; shift <= scale_; ++shift) {
      PullFrom(features, y + side * scale_, x + shift, best);
    }
    bool grew = !std::equal(best.begin(), best.end(), strengths);
    if (grew) std::copy(best.begin(), best.end(), strengths);
    grew |= PullAlongRow<side>(features, strengths);
    return grew;
  }

  void PullFrom(const std::uint8_t* features, int y, int x, std::array<float, kBlock_px>& best) {
    const std::uint8_t* other_features = features_.ptr<std::uint8_t>(y) + x;
    const float* other_strengths = strengths_.ptr<float>(y) + x;
    for (std::size_t i = 0; i < kBlock_px; ++i) {
      const float strength = other_strengths[i] * Factor(features[i], other_features[i]);
      best[i] = strength > best[i] ? strength : best[i];
    }
  }

  // A strength may pass on through the pixels of one block, so they take their turns in order.
  template <int side>
  bool PullAlongRow(const std::uint8_t* features, float* strengths) {
    std::array<float, kBlock_px> factors;
    const std::uint8_t* other_features = features + side * scale_;
    for (std::size_t i = 0; i < kBlock_px; ++i) {
      factors[i] = Factor(features[i], other_features[i]);
    }
    bool grew = false;
    for (int turn = 0; turn < kBlock_px; ++turn) {
      const int i = side < 0 ? turn : kBlock_px - 1 - turn;
      const float strength = strengths[i + side * scale_] * factors[static_cast<std::size_t>(i)];
      grew |= strength > strengths[i];
      strengths[i] = strength > strengths[i] ? strength : strengths[i];
    }
    return grew;
  }

  int scale_;
  int rows_;
  int blocks_;
  PendingBlocks down_;
  PendingBlocks up_;
  cv::Mat features_;
  cv::Mat strengths_;
};

}  // namespace

cv::Mat PropagateStrength(const cv::Mat& channel, int scale) {
  if (std::min(channel.rows, channel.cols) <= 2 * scale) {
    return cv::Mat::ones(channel.size(), CV_32F);  // nothing but border
  }
  const cv::Mat strengths = Propagation(channel, scale).Run();
  return strengths.colRange(0, channel.cols).clone();
}

}  // namespace fovea
