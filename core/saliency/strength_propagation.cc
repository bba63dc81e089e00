// PropagateStrength: Eq. 3 and 4 iterated to their fixed point.
//
// A strength is the best product of factors along any path from the border. Every factor lies in
// [0, 1] and rounded multiplication is monotone, so the strengths only grow from 0 and end in the
// same bits whatever the order of the updates. That freedom buys the speed: sweeps down and up the
// image in turn carry a strength along a whole path at once, sixteen pixels side by side, and
// leave out the blocks none of whose neighbours grew since they were last looked at.
#include <algorithm>
#include <cstdint>
#include <opencv2/core.hpp>
#include <utility>
#include <vector>

#include "core/saliency/strength_block.h"
#include "core/saliency/strength_saliency.h"

namespace fovea {
namespace {

constexpr int kBlock_px = StrengthBlock::kSize_px;

// The blocks that the sweeps in one direction still have to look at.
class PendingBlocks {
 public:
  PendingBlocks(int rows, int blocks)
      : flags_(cv::Mat::ones(rows, blocks + 2, CV_8U)), rows_(static_cast<std::size_t>(rows), 1) {}

  // The block before the first and the one past the last may be marked and are never taken.
  void Mark(int row, int block, bool pending = true) {
    flags_.ptr<std::uint8_t>(row)[block + 1] |= static_cast<std::uint8_t>(pending);
    rows_[static_cast<std::size_t>(row)] = 1;
  }
  // These answer whether something was marked, and unmark it.
  bool TakeRow(int row) { return std::exchange(rows_[static_cast<std::size_t>(row)], 0) != 0; }
  bool TakeBlock(int row, int block) {
    return std::exchange(flags_.ptr<std::uint8_t>(row)[block + 1], std::uint8_t{0}) != 0;
  }

 private:
  cv::Mat flags_;
  std::vector<char> rows_;
};

class Propagation {
 public:
  Propagation(const cv::Mat& channel, int scale)
      : scale_(scale),
        rows_(channel.rows),
        blocks_((channel.cols - 2 * scale + kBlock_px - 1) / kBlock_px),
        cols_(blocks_ * kBlock_px + 2 * scale),
        down_(rows_, blocks_),
        up_(rows_, blocks_) {
    // Blocks are whole: columns past the image are border, which nothing inside looks at.
    cv::copyMakeBorder(channel, features_, 0, 0, 0, cols_ - channel.cols, cv::BORDER_REPLICATE);
    strengths_ = cv::Mat::ones(rows_, cols_, CV_32F);
    const cv::Rect inside(scale, scale, channel.cols - 2 * scale, rows_ - 2 * scale);
    strengths_(inside) = 0.0F;
  }

  cv::Mat Run() {
    for (bool grew = true; grew;) {
      grew = SweepDown();
      grew |= SweepUp();
    }
    return strengths_;
  }

 private:
  // The pending blocks pull from above, row by row from the top. Returns whether any grew.
  bool SweepDown() {
    bool grew = false;
    for (int y = scale_; y < rows_ - scale_; ++y) {
      if (!down_.TakeRow(y)) continue;
      for (int block = 0; block < blocks_; ++block) {
        if (down_.TakeBlock(y, block)) grew |= Update(y, block, -1);
      }
    }
    return grew;
  }

  // The pending blocks pull from below, row by row from the bottom.
  bool SweepUp() {
    bool grew = false;
    for (int y = rows_ - scale_ - 1; y >= scale_; --y) {
      if (!up_.TakeRow(y)) continue;
      for (int block = blocks_ - 1; block >= 0; --block) {
        if (up_.TakeBlock(y, block)) grew |= Update(y, block, +1);
      }
    }
    return grew;
  }

  bool Update(int y, int block, int side) {
    const unsigned grown = Pull(y, block, side);
    if (grown != 0) MarkNeighbours(y, block, grown);
    return grown != 0;
  }

  // Raises a block by the part of its ring above (side = -1) or below (+1) and in its own row.
  // Returns the pixels that grew, one bit each.
  unsigned Pull(int y, int block, int side) {
    const std::ptrdiff_t at =
        std::ptrdiff_t{y} * cols_ + scale_ + std::ptrdiff_t{block} * kBlock_px;
    const std::uint8_t* features = features_.ptr<std::uint8_t>() + at;
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
    unsigned grown = own.Store(strengths);

    // Along the row a strength may pass through several pixels of this same block.
    for (unsigned more = 1; more != 0; grown |= more) {
      pull_from(0, -scale_);
      pull_from(0, +scale_);
      more = own.Store(strengths);
    }
    return grown;
  }

  // Only growth within `scale` of a block's end reaches the next block.
  void MarkNeighbours(int y, int block, unsigned grown) {
    const bool left = (grown & ((1U << scale_) - 1U)) != 0;
    const bool right = grown >> (kBlock_px - scale_) != 0;
    // The next sweep of either kind meets the blocks beside this one; one of them suffices.
    down_.Mark(y, block + 1, right);
    up_.Mark(y, block - 1, left);
    for (int step = 1; step <= scale_; ++step) {
      MarkRow(down_, y + step, block, left, right);
      MarkRow(up_, y - step, block, left, right);
    }
  }

  static void MarkRow(PendingBlocks& pending, int y, int block, bool left, bool right) {
    pending.Mark(y, block - 1, left);
    pending.Mark(y, block);
    pending.Mark(y, block + 1, right);
  }

  int scale_;
  int rows_;
  int blocks_;  // in a row, without the border
  int cols_;
  PendingBlocks down_;
  PendingBlocks up_;
  cv::Mat features_;   // CV_8UC1, rows_ × cols_
  cv::Mat strengths_;  // CV_32FC1, rows_ × cols_
};

}  // namespace

cv::Mat PropagateStrength(const cv::Mat& channel, int scale) {
  if (std::min(channel.rows, channel.cols) <= 2 * scale) {
    return cv::Mat::ones(channel.size(), CV_32F);  // nothing but border
  }
  return Propagation(channel, scale).Run().colRange(0, channel.cols).clone();
}

}  // namespace fovea
