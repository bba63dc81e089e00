// PropagateStrength: Eq. 3 and 4 iterated to their fixed point.
//
// A strength is the best product of factors along any path from the border. Every factor lies in
// [0, 1] and rounded multiplication is monotone, so the strengths only grow from 0 and end in the
// same bits whatever the order of the updates. That freedom buys the speed: sweeps down and up the
// image in turn carry a strength along a whole path at once, a block of pixels side by side. They
// start at the border, leave out the blocks none of whose neighbours grew since they were last
// looked at, and at first those whose neighbours grew little: what comes from there is often
// surpassed later.
#include <algorithm>
#include <cstdint>
#include <opencv2/core.hpp>

#include "core/saliency/strength_saliency.h"
#include "core/types/interruption.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/saliency/strength_propagation.cc"
#include <hwy/foreach_target.h>
// After foreach_target.h, which includes this file once more for each instruction set.
#include "core/saliency/strength_block-inl.h"

HWY_BEFORE_NAMESPACE();
namespace fovea::HWY_NAMESPACE {
namespace {

constexpr int kBlock_px = StrengthBlock::kSize_px;

// A round of sweeps takes the blocks beside strengths of at least this share of the largest that
// is waiting. On recorded frames 0.9 to 0.97 take the same time.
constexpr float kShareOfRound = 0.95F;

class Propagation {
 public:
  Propagation(const cv::Mat& channel, int scale)
      : scale_(scale),
        end_(channel.rows - scale),
        blocks_((channel.cols - 2 * scale + kBlock_px - 1) / kBlock_px),
        cols_((blocks_ + 2) * kBlock_px),
        down_(channel.rows, scale, blocks_),
        up_(down_),
        maps_(2 * channel.rows, cols_, CV_32F),
        features_(maps_.rowRange(0, channel.rows)),
        strengths_(maps_.rowRange(channel.rows, maps_.rows)) {
    InterruptionPoint();
    SetFeatures(channel);
    SetStart(channel.cols - 2 * scale);
    MarkBesideBorder();
  }

  HWY_INLINE void Run() {
    while (const float largest = std::max(down_.Largest(), up_.Largest())) {
      least_ = largest * kShareOfRound;
      for (bool again = true; again;) {
        again = false;
        for (int y = scale_; y < end_; ++y) again |= Sweep(down_, y, -1);
        for (int y = end_ - 1; y >= scale_; --y) again |= Sweep(up_, y, +1);
      }
    }
  }

  cv::Mat Strengths(int cols) const {
    return strengths_.colRange(kBlock_px - scale_, kBlock_px - scale_ + cols);
  }

 private:
  // Those of the image's border go on beyond it.
  void SetFeatures(const cv::Mat& channel) {
    for (int y = 0; y < channel.rows; ++y) {
      const std::uint8_t* from = channel.ptr(y);
      float* row = features_.ptr<float>(y);
      float* to = row + kBlock_px - scale_;
      for (int x = 0; x < channel.cols; ++x) to[x] = from[x] * StrengthBlock::kFeatureStep;
      std::fill(row, to, to[0]);
      std::fill(to + channel.cols, row + cols_, to[channel.cols - 1]);
    }
  }

  // One within `scale` of the ends, where nothing pulls, and 0 elsewhere.
  void SetStart(int cols_inside) {
    for (int y = 0; y < strengths_.rows; ++y) {
      float* row = strengths_.ptr<float>(y);
      float* inside = row + kBlock_px;
      std::fill(row, inside, 1.0F);
      std::fill_n(inside, cols_inside, y >= scale_ && y < end_ ? 0.0F : 1.0F);
      std::fill(inside + cols_inside, row + cols_, 1.0F);
    }
  }

  void MarkBesideBorder() {
    const auto mark = [&](int y, int block) {
      down_.Mark(y, block, {.all = 1});
      up_.Mark(y, block, {.all = 1});
    };
    for (int y = scale_; y < end_; ++y) {
      const bool whole_row = y < 2 * scale_ || y >= end_ - scale_;
      for (int block = 0; block < blocks_; ++block) {
        // The last block may end within the border.
        if (whole_row || block == 0 || block >= blocks_ - 2) mark(y, block);
      }
    }
  }

  struct Pulled {
    Growth growth;
    bool goes_on = false;  // the block may grow by itself
  };

  // The pending blocks of a row pull from above (side = -1) or below (+1). Returns whether there
  // were any.
  HWY_INLINE bool Sweep(PendingBlocks& pending, int y, int side) {
    if (!pending.RowHas(y, least_)) return false;
    for (int i = 0; i < blocks_; ++i) {
      const int block = side < 0 ? i : blocks_ - 1 - i;
      const float beside = pending.Take(y, block, least_);
      const std::ptrdiff_t at = std::ptrdiff_t{y} * cols_ + std::ptrdiff_t{block + 1} * kBlock_px;
      if (beside == 0 || !StrengthBlock::CanGrow(strengths_.ptr<float>() + at, beside)) continue;
      loop_.Turn();
      const Pulled pulled = Pull(at, side);
      if (pulled.growth.all > 0) MarkNeighbours(y, block, pulled);
    }
    pending.FinishRow(y);
    return true;
  }

  HWY_INLINE Pulled Pull(std::ptrdiff_t at, int side) {
    switch (scale_) {  // the paper's are compiled with their offsets known
      case 1:
        return PullAtScale(at, side, 1);
      case 2:
        return PullAtScale(at, side, 2);
      case 3:
        return PullAtScale(at, side, 3);
      case 4:
        return PullAtScale(at, side, 4);
      default:
        return PullAtScale(at, side, scale_);
    }
  }

  // Raises a block by the part of its ring on one side and in its own row.
  HWY_INLINE Pulled PullAtScale(std::ptrdiff_t at, int side, int scale) {
    const float* features = features_.ptr<float>() + at;
    float* strengths = strengths_.ptr<float>() + at;
    StrengthBlock own(features, strengths);
    const auto pull_from = [&](int rows_off, int cols_off) HWY_ATTR {
      const std::ptrdiff_t offset = std::ptrdiff_t{rows_off} * cols_ + cols_off;
      own.PullFrom(features + offset, strengths + offset);
    };
    for (int step = 1; step < scale; ++step) {
      pull_from(side * step, -scale);
      pull_from(side * step, +scale);
    }
    for (int shift = -scale; shift <= scale; ++shift) pull_from(side * scale, shift);
    const bool goes_on = own.PullAlongRow(features, strengths, scale);
    const Growth growth = own.GrowthSoFar(scale);
    if (growth.all > 0) own.Store(strengths);
    return {growth, goes_on};
  }

  // Only growth within `scale` of a block's end reaches the next block.
  HWY_INLINE void MarkNeighbours(int y, int block, const Pulled& pulled) {
    const Growth& growth = pulled.growth;
    // The next sweep of either kind meets the blocks beside this one, and itself; one suffices.
    down_.Mark(y, block, {.right = growth.right});
    up_.Mark(y, block, {.left = growth.left, .all = pulled.goes_on ? growth.all : 0});
    for (int step = 1; step <= scale_; ++step) {
      down_.Mark(y + step, block, growth);
      up_.Mark(y - step, block, growth);
    }
  }

  int scale_;
  int end_;          // one past the last row inside the border
  int blocks_;       // in a row, from the first pixel inside the border on
  int cols_;         // with a block of border on either side
  float least_ = 0;  // what the sweeps of this round leave out
  LongLoop loop_;
  PendingBlocks down_;
  PendingBlocks up_;
  cv::Mat maps_;      // CV_32FC1, cols_ wide: the two
  cv::Mat features_;  // in steps of StrengthBlock::kFeatureStep
  cv::Mat strengths_;
};

}  // namespace

cv::Mat PropagateInside(const cv::Mat& channel, int scale) {
  Propagation propagation(channel, scale);
  propagation.Run();
  return propagation.Strengths(channel.cols);
}

}  // namespace fovea::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fovea {

HWY_EXPORT(PropagateInside);

cv::Mat PropagateStrength(const cv::Mat& channel, int scale) {
  if (std::min(channel.rows, channel.cols) <= 2 * scale) {
    return cv::Mat::ones(channel.size(), CV_32F);  // nothing but border
  }
  return HWY_DYNAMIC_DISPATCH(PropagateInside)(channel, scale);
}

}  // namespace fovea
#endif
