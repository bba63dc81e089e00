// PropagateStrength: Eq. 3 and 4 iterated to their fixed point.
//
// A strength is the best product of factors along any path from the border. Every factor lies in
// [0, 1] and rounded multiplication is monotone, so the strengths only grow from 0 and end in the
// same bits whatever the order of the updates. That freedom buys the speed: sweeps down and up the
// image in turn carry a strength along a whole path at once, sixteen pixels side by side. They
// leave out the blocks none of whose neighbours grew since they were last looked at, and at first
// those whose neighbours grew little: what comes from there is often surpassed later.
#include <algorithm>
#include <opencv2/core.hpp>
#include <utility>
#include <vector>

#include "core/saliency/strength_block.h"
#include "core/saliency/strength_saliency.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

constexpr int kBlock_px = StrengthBlock::kSize_px;

// A round of sweeps takes the blocks beside strengths of at least this share of the largest that
// is waiting. On recorded frames 0.98 looks at a quarter to a half fewer blocks than 0.
constexpr float kShareOfRound = 0.98F;

// The blocks that the sweeps in one direction still have to look at, each with the largest strength
// that has grown beside it; 0: none.
class PendingBlocks {
 public:
  PendingBlocks(int first_row, int end_row, int blocks)
      : first_row_(first_row),
        blocks_(blocks),
        strengths_(cv::Mat::ones(end_row - first_row, blocks, CV_32F)),
        largest_of_row_(static_cast<std::size_t>(end_row - first_row), 1.0F) {}

  // Outside the image nothing happens.
  FOVEA_INLINE void Mark(int y, int block, const StrengthBlock::Growth& growth) {
    const int row = y - first_row_;
    if (row < 0 || row >= strengths_.rows) return;
    float* strengths = strengths_.ptr<float>(row);
    if (block > 0) Raise(strengths[block - 1], growth.first);
    Raise(strengths[block], growth.all);
    if (block + 1 < blocks_) Raise(strengths[block + 1], growth.last);
    Raise(largest_of_row_[static_cast<std::size_t>(row)],
          std::max({growth.first, growth.all, growth.last}));
  }

  bool RowHas(int y, float least) const {
    return largest_of_row_[static_cast<std::size_t>(y - first_row_)] >= least;
  }
  // Answers whether a block waits beside at least this strength, and takes it out.
  bool Take(int y, int block, float least) {
    float& strength = strengths_.at<float>(y - first_row_, block);
    if (strength < least) return false;
    strength = 0;
    return true;
  }
  void FinishRow(int y) {
    const float* strengths = strengths_.ptr<float>(y - first_row_);
    largest_of_row_[static_cast<std::size_t>(y - first_row_)] =
        *std::max_element(strengths, strengths + blocks_);
  }
  float Largest() const {
    return *std::max_element(largest_of_row_.begin(), largest_of_row_.end());
  }

 private:
  static void Raise(float& value, float to) { value = std::max(value, to); }

  int first_row_;
  int blocks_;
  cv::Mat strengths_;  // CV_32FC1, one value a block
  std::vector<float> largest_of_row_;
};

class Propagation {
 public:
  Propagation(const cv::Mat& channel, int scale)
      : scale_(scale),
        end_(channel.rows - scale),
        blocks_((channel.cols - 2 * scale + kBlock_px - 1) / kBlock_px),
        cols_(blocks_ * kBlock_px + 2 * scale),
        down_(scale, end_, blocks_),
        up_(scale, end_, blocks_) {
    // Blocks are whole: columns past the image are border, which nothing inside looks at.
    InterruptionPoint();
    cv::copyMakeBorder(channel, features_, 0, 0, 0, cols_ - channel.cols, cv::BORDER_REPLICATE);
    features_.convertTo(features_, CV_32F);
    strengths_ = cv::Mat::ones(channel.rows, cols_, CV_32F);
    const cv::Rect inside(scale, scale, channel.cols - 2 * scale, channel.rows - 2 * scale);
    strengths_(inside) = 0.0F;
  }

  FOVEA_INLINE void Run() {
    while (const float largest = std::max(down_.Largest(), up_.Largest())) {
      least_ = largest * kShareOfRound;
      for (bool again = true; again;) {
        again = false;
        for (int y = scale_; y < end_; ++y) again |= Sweep(down_, y, -1);
        for (int y = end_ - 1; y >= scale_; --y) again |= Sweep(up_, y, +1);
      }
    }
  }

  const cv::Mat& strengths() const { return strengths_; }

 private:
  // The pending blocks of a row pull from above (side = -1) or below (+1). Returns whether there
  // were any.
  FOVEA_INLINE bool Sweep(PendingBlocks& pending, int y, int side) {
    if (!pending.RowHas(y, least_)) return false;
    for (int i = 0; i < blocks_; ++i) {
      const int block = side < 0 ? i : blocks_ - 1 - i;
      if (!pending.Take(y, block, least_)) continue;
      loop_.Turn();
      const StrengthBlock::Growth growth = Pull(y, block, side);
      if (growth.all > 0) MarkNeighbours(y, block, growth);
    }
    pending.FinishRow(y);
    return true;
  }

  // Raises a block by the part of its ring on one side and in its own row.
  FOVEA_INLINE StrengthBlock::Growth Pull(int y, int block, int side) {
    const std::ptrdiff_t at =
        std::ptrdiff_t{y} * cols_ + scale_ + std::ptrdiff_t{block} * kBlock_px;
    const float* features = features_.ptr<float>() + at;
    float* strengths = strengths_.ptr<float>() + at;
    StrengthBlock own(features, strengths);
    const auto pull_from = [&](int rows_off, int cols_off) {
      const std::ptrdiff_t offset = std::ptrdiff_t{rows_off} * cols_ + cols_off;
      own.PullFrom(features + offset, strengths + offset);
    };

    for (int step = 1; step < scale_; ++step) {
      pull_from(side * step, -scale_);
      pull_from(side * step, +scale_);
    }
    for (int shift = -scale_; shift <= scale_; ++shift) pull_from(side * scale_, shift);
    own.Store(strengths);

    // Along the row a strength may pass through several pixels of this same block.
    do {
      pull_from(0, -scale_);
      pull_from(0, +scale_);
    } while (own.Store(strengths));
    return own.GrowthSoFar(scale_);
  }

  // Only growth within `scale` of a block's end reaches the next block.
  FOVEA_INLINE void MarkNeighbours(int y, int block, const StrengthBlock::Growth& growth) {
    // The next sweep of either kind meets the blocks beside this one; one of them suffices.
    down_.Mark(y, block, {.last = growth.last});
    up_.Mark(y, block, {.first = growth.first});
    for (int step = 1; step <= scale_; ++step) {
      down_.Mark(y + step, block, growth);
      up_.Mark(y - step, block, growth);
    }
  }

  int scale_;
  int end_;     // one past the last row inside the border
  int blocks_;  // in a row, without the border
  int cols_;
  float least_ = 0;  // what the sweeps of this round leave out
  LongLoop loop_;
  PendingBlocks down_;
  PendingBlocks up_;
  cv::Mat features_;   // CV_32FC1, whole numbers 0 … 255, cols_ wide
  cv::Mat strengths_;  // CV_32FC1, cols_ wide
};

}  // namespace

cv::Mat PropagateStrength(const cv::Mat& channel, int scale) {
  if (std::min(channel.rows, channel.cols) <= 2 * scale) {
    return cv::Mat::ones(channel.size(), CV_32F);  // nothing but border
  }
  Propagation propagation(channel, scale);
  RunInWidestRegisters([&] { propagation.Run(); });
  return propagation.strengths().colRange(0, channel.cols).clone();
}

}  // namespace fovea
