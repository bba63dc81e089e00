// Which parts of an image PropagateStrength still has to look at.
#pragma once

#include <hwy/base.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace fovea {

// The largest strength among those of a block that have grown (0: none has): over all its pixels,
// over those near its left end and near its right end.
struct Growth {
  float all = 0, left = 0, right = 0;
};

// The blocks that the sweeps in one direction still have to look at, each with the largest strength
// that has grown beside it; 0: none.
class PendingBlocks {
 public:
  // For `num_rows` rows of `num_blocks` blocks from `first_row` on.
  PendingBlocks(int first_row, int num_rows, int num_blocks)
      : first_row_(first_row),
        num_blocks_(num_blocks),
        strengths_(static_cast<std::size_t>(num_rows) * static_cast<std::size_t>(num_blocks)),
        largest_of_row_(static_cast<std::size_t>(num_rows)) {}

  // That the block has grown so, for what lies above or below it. Outside the image nothing
  // happens.
  HWY_INLINE void Mark(int y, int block, const Growth& growth) {
    const int row = y - first_row_;
    if (row < 0 || row >= static_cast<int>(largest_of_row_.size())) return;
    float* strengths = Row(row);
    if (block > 0) Raise(strengths[block - 1], growth.left);
    Raise(strengths[block], growth.all);
    if (block + 1 < num_blocks_) Raise(strengths[block + 1], growth.right);
    Raise(largest_of_row_[static_cast<std::size_t>(row)],
          std::max(std::max(growth.left, growth.all), growth.right));
  }

  HWY_INLINE bool RowHas(int y, float least) const {
    return largest_of_row_[static_cast<std::size_t>(y - first_row_)] >= least;
  }
  // The strength that a block waits beside, and takes it out; 0 if that is less than `least`.
  HWY_INLINE float Take(int y, int block, float least) {
    float& strength = Row(y - first_row_)[block];
    return strength < least ? 0 : std::exchange(strength, 0.0F);
  }
  HWY_INLINE void FinishRow(int y) {
    const float* strengths = Row(y - first_row_);
    largest_of_row_[static_cast<std::size_t>(y - first_row_)] =
        *std::max_element(strengths, strengths + num_blocks_);
  }
  float Largest() const {
    return *std::max_element(largest_of_row_.begin(), largest_of_row_.end());
  }

 private:
  static HWY_INLINE void Raise(float& value, float to) { value = std::max(value, to); }
  HWY_INLINE float* Row(int row) {
    return strengths_.data() + static_cast<std::ptrdiff_t>(row) * num_blocks_;
  }

  int first_row_;
  int num_blocks_;                     // in a row
  std::vector<float> strengths_;       // row-major
  std::vector<float> largest_of_row_;  // so that rows without any cost nothing
};

}  // namespace fovea
