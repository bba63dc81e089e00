// Which parts of an image PropagateStrength still has to look at.
#pragma once

#include <hwy/base.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace fovea {

// The largest strength among those of a block that have grown (0: none has): over its pixels near
// its left end, over all of them, over those near its right end.
struct Growth {
  float left = 0, all = 0, right = 0;
};

// The blocks that the sweeps in one direction still have to look at, each with the largest strength
// that has grown beside it; 0: none.
class PendingBlocks {
 public:
  // For `num_rows` rows of `num_blocks` blocks. The first and last `border` rows may be marked, but
  // there is nothing to look at.
  PendingBlocks(int num_rows, int border, int num_blocks)
      : border_(border),
        num_blocks_(num_blocks),
        stride_(num_blocks + kMargin),
        num_rows_(num_rows),
        strengths_(static_cast<std::size_t>(num_rows) * static_cast<std::size_t>(stride_ + 1)) {}

  // That the block has grown so, for what lies above or below it.
  HWY_INLINE void Mark(int y, int block, const Growth& growth) {
    float* around = Row(y) + block - 1;
    const float grown[kMargin + 1] = {growth.left, growth.all, growth.right, 0};
    for (int i = 0; i <= kMargin; ++i) Raise(around[i], grown[i]);
    Raise(LargestOfRows()[y], std::max(std::max(growth.left, growth.all), growth.right));
  }

  HWY_INLINE bool RowHas(int y, float least) const { return LargestOfRows()[y] >= least; }
  // The strength that a block waits beside, and takes it out; 0 if that is less than `least`.
  HWY_INLINE float Take(int y, int block, float least) {
    float& strength = Row(y)[block];
    return strength < least ? 0 : std::exchange(strength, 0.0F);
  }
  HWY_INLINE void FinishRow(int y) {
    const float* strengths = Row(y);
    LargestOfRows()[y] = *std::max_element(strengths, strengths + num_blocks_);
  }
  float Largest() const {
    return *std::max_element(LargestOfRows() + border_, LargestOfRows() + num_rows_ - border_);
  }

 private:
  // One block before a row and two after it, so that marks fill a register and ask for no bounds.
  static constexpr int kMargin = 3;

  static HWY_INLINE void Raise(float& value, float to) { value = std::max(value, to); }
  HWY_INLINE float* Row(int y) { return strengths_.data() + std::ptrdiff_t{y} * stride_ + 1; }
  // So that rows without any cost nothing.
  HWY_INLINE float* LargestOfRows() { return strengths_.data() + AfterRows(); }
  HWY_INLINE const float* LargestOfRows() const { return strengths_.data() + AfterRows(); }
  HWY_INLINE std::ptrdiff_t AfterRows() const { return std::ptrdiff_t{num_rows_} * stride_; }

  int border_;
  int num_blocks_;  // in a row
  int stride_;      // with its margin
  int num_rows_;
  std::vector<float> strengths_;  // row-major; after them the largest of each row
};

}  // namespace fovea
