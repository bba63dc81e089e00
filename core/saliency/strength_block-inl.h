// The strengths of some pixels of one image row, held in vector registers: the inner step of
// PropagateStrength. Compiled once for each instruction set; the bits are the same in all.
#if defined(FOVEA_STRENGTH_BLOCK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FOVEA_STRENGTH_BLOCK_INL_H_
#undef FOVEA_STRENGTH_BLOCK_INL_H_
#else
#define FOVEA_STRENGTH_BLOCK_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>

#include "core/saliency/pending_blocks.h"

HWY_BEFORE_NAMESPACE();
namespace fovea::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Scales 1 … kMaxScale.
constexpr int kMaxScale = 8;

class StrengthBlock {
 public:
  using Tag = hn::CappedTag<float, 16>;
  using Lanes = hn::Vec<Tag>;
  static constexpr int kLanes = static_cast<int>(hn::MaxLanes(Tag()));
  // More pixels share the cost of a visit, fewer leave registers free and need fewer visits each.
  static constexpr int kParts = kLanes >= 4 ? 4 : 16 / kLanes;
  static constexpr int kSize_px = kParts * kLanes;

  // The features are whole numbers 0 … 255 in steps of this.
  static constexpr float kFeatureStep = 0x1.0101p-8F;

  // A pointer to the first pixel of the block each.
  HWY_INLINE StrengthBlock(const float* features, const float* strengths) {
    for (int part = 0; part < kParts; ++part) {
      features_[part] = Load(features, part);
      before_[part] = strengths_[part] = Load(strengths, part);
    }
  }

  // Whether a neighbour of this strength might raise any pixel.
  static HWY_INLINE bool CanGrow(const float* strengths, float beside) {
    const Lanes most = hn::Set(Tag(), beside);
    auto below = hn::Lt(hn::LoadU(Tag(), strengths), most);
    for (int part = 1; part < kParts; ++part) {
      below = hn::Or(below, hn::Lt(Load(strengths, part), most));
    }
    return !hn::AllFalse(Tag(), below);
  }

  // Eq. 3 and 4 for one neighbour each: strength = max(strength, neighbour's · (1 − |difference| /
  // 255)). The features and strengths are those of the neighbours.
  HWY_INLINE void PullFrom(const float* features, const float* strengths) {
    for (int part = 0; part < kParts; ++part) {
      const Lanes factor = Factor(features_[part], Load(features, part));
      const Lanes strength = Load(strengths, part);
      strengths_[part] = hn::Max(strengths_[part], hn::Mul(strength, factor));
    }
  }

  // The same for the neighbours `scale` to the left and to the right, some times over: a strength
  // may pass through several pixels of the block. Returns whether it may go on. The pointers are
  // those of the block itself.
  HWY_INLINE bool PullAlongRow(const float* features, const float* strengths, int scale) {
    Lanes left_factors[kParts], right_factors[kParts];
    for (int part = 0; part < kParts; ++part) {
      left_factors[part] = Factor(features_[part], Load(features - scale, part));
      right_factors[part] = Factor(features_[part], Load(features + scale, part));
    }
    Row row(strengths, scale);
    bool goes_on = true;
    for (int turn = scale == 1 ? 3 : 1; goes_on && turn > 0; --turn) {  // so many cost least
      row.Set(strengths_);
      goes_on = Raise(row, left_factors, right_factors);
    }
    return goes_on;
  }

  // What has grown since it was loaded. `few`: how many pixels are near an end.
  HWY_INLINE Growth GrowthSoFar(int few) const {
    Lanes all = hn::Zero(Tag()), left = all, right = all;
    for (int part = 0; part < kParts; ++part) {
      const auto has_grown = hn::Lt(before_[part], strengths_[part]);
      const Lanes grown = hn::IfThenElseZero(has_grown, strengths_[part]);
      all = hn::Max(all, grown);
      left = hn::Max(left, hn::IfThenElseZero(First(few - part * kLanes), grown));
      const auto not_right = First(kSize_px - few - part * kLanes);
      right = hn::Max(right, hn::IfThenZeroElse(not_right, grown));
    }
    const float most = Largest(all);
    if (most == 0) return {};
    return {Largest(left), most, Largest(right)};
  }

  HWY_INLINE void Store(float* strengths) const {
    for (int part = 0; part < kParts; ++part) {
      hn::StoreU(strengths_[part], Tag(), strengths + std::ptrdiff_t{part} * kLanes);
    }
  }

 private:
  static HWY_INLINE Lanes Load(const float* block, int part) {
    return hn::LoadU(Tag(), block + std::ptrdiff_t{part} * kLanes);
  }

  // A block between its neighbours, and what lies `scale` to the left and right of each part of it,
  // without a way through memory.
  class Row {
   public:
    HWY_INLINE Row(const float* strengths, int scale)
        : whole_(scale / kLanes), rest_(scale % kLanes) {
      for (int i = 0; i < kAround; ++i) {
        parts_[i] = Load(strengths, i - kAround);
        parts_[kAround + kParts + i] = Load(strengths, kParts + i);
      }
    }
    HWY_INLINE void Set(const Lanes* strengths) {
      for (int part = 0; part < kParts; ++part) parts_[kAround + part] = strengths[part];
    }
    HWY_INLINE Lanes Left(int part) const {
      const int at = kAround + part - whole_;
      if (rest_ == 0) return parts_[at];
      const auto is_own = First(kLanes - rest_);
      return Rotated(hn::IfThenElse(is_own, parts_[at], parts_[at - 1]), kLanes - rest_);
    }
    HWY_INLINE Lanes Right(int part) const {
      const int at = kAround + part + whole_;
      if (rest_ == 0) return parts_[at];
      const auto is_next = First(rest_);
      return Rotated(hn::IfThenElse(is_next, parts_[at + 1], parts_[at]), rest_);
    }

   private:
    static constexpr int kAround = (kMaxScale + kLanes - 1) / kLanes;
    static_assert(kAround <= kParts);

    // By so many places to the left.
    static HWY_INLINE Lanes Rotated(Lanes lanes, int places) {
      const hn::RebindToSigned<Tag> integers;
      const auto from = hn::And(hn::Iota(integers, places), hn::Set(integers, kLanes - 1));
      return hn::TableLookupLanes(lanes, hn::IndicesFromVec(Tag(), from));
    }

    int whole_, rest_;  // the scale in vectors and lanes
    Lanes parts_[2 * kAround + kParts];
  };

  // Returns whether any pixel grew.
  HWY_INLINE bool Raise(const Row& row, const Lanes* left_factors, const Lanes* right_factors) {
    auto grew = First(0);
    for (int part = 0; part < kParts; ++part) {
      const Lanes before = strengths_[part];
      const Lanes beside = hn::Max(hn::Mul(row.Left(part), left_factors[part]),
                                   hn::Mul(row.Right(part), right_factors[part]));
      strengths_[part] = hn::Max(before, beside);
      grew = hn::Or(grew, hn::Lt(before, strengths_[part]));
    }
    return !hn::AllFalse(Tag(), grew);
  }

  // 1 − |difference| / 255. In steps of kFeatureStep a difference is its 255th but for 2^-24 of
  // itself, and exact; with that added it rounds to the quotient by 255, bit for bit, fused or not,
  // at a fraction of a division's cost.
  static HWY_INLINE Lanes Factor(Lanes a, Lanes b) {
    const Lanes difference = hn::Abs(hn::Sub(a, b));
    const Lanes quotient = hn::MulAdd(difference, hn::Set(Tag(), 0x1p-24F), difference);
    return hn::Sub(hn::Set(Tag(), 1.0F), quotient);
  }

  // The mask of so many lanes; of none or all where there are not so many.
  static HWY_INLINE auto First(int count) -> hn::Mask<Tag> {
    return hn::FirstN(Tag(), static_cast<std::size_t>(std::clamp(count, 0, kLanes)));
  }

  static HWY_INLINE float Largest(Lanes lanes) { return hn::GetLane(hn::MaxOfLanes(Tag(), lanes)); }

  Lanes features_[kParts], before_[kParts], strengths_[kParts];
};

}  // namespace fovea::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include guard, once for each instruction set
