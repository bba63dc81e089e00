// Numbers of lattice cells: a hash table without allocations of its own for each entry.
#pragma once

#include <Eigen/Core>
#include <bit>
#include <cstdint>
#include <vector>

namespace fovea {

// What the key of a cell grows by with this step to another one, modulo 2^64.
inline std::uint64_t CellKeyStep(const Eigen::Vector3i& step) {
  const auto bits = [](int value) { return static_cast<std::uint64_t>(value); };
  return (bits(step.x()) << 42U) + (bits(step.y()) << 21U) + bits(step.z());
}

// One number for a cell, in the order of x, then y, then z: 21 bits an axis, ± 10 km at 1 cm, far
// beyond any depth camera. Cells farther out share theirs with others.
inline std::uint64_t CellKey(const Eigen::Vector3i& cell) {
  constexpr unsigned kMask = (1U << 21U) - 1;
  const auto part = [](int value) {
    return static_cast<std::uint64_t>((static_cast<unsigned>(value) + (1U << 20U)) & kMask);
  };
  return part(cell.x()) << 42U | part(cell.y()) << 21U | part(cell.z());
}

class CellIndex {
 public:
  // Grows with what is added; `expected` cells fit without.
  explicit CellIndex(std::size_t expected = 0)
      : slots_(std::bit_ceil(2 * expected + 16)), num_free_(slots_.size() / 2) {}

  // The number of a cell, or -1.
  int Find(const Eigen::Vector3i& cell) const { return slots_[SlotOf(CellKey(cell))].number; }

  // Gives a new cell this number (≥ 0). Returns the cell's number.
  int FindOrAdd(const Eigen::Vector3i& cell, int number) {
    const std::uint64_t key = CellKey(cell);
    Slot& slot = slots_[SlotOf(key)];
    if (slot.number >= 0) return slot.number;
    slot = {key, number};
    if (--num_free_ == 0) Grow();
    return number;
  }

 private:
  struct Slot {
    std::uint64_t key = 0;
    int number = -1;
  };

  // Where the key is or would be. Fibonacci hashing, whose highest bits depend on all of the key,
  // spreads neighbouring cells.
  std::size_t SlotOf(std::uint64_t key) const {
    const std::size_t last = slots_.size() - 1;
    std::size_t slot = key * 0x9E3779B97F4A7C15ULL >> std::countl_zero(last);
    while (slots_[slot].number >= 0 && slots_[slot].key != key) slot = (slot + 1) & last;
    return slot;
  }

  void Grow() {
    std::vector<Slot> before(2 * slots_.size());
    before.swap(slots_);
    num_free_ = slots_.size() / 4;
    for (const Slot& slot : before) {
      if (slot.number >= 0) slots_[SlotOf(slot.key)] = slot;
    }
  }

  std::vector<Slot> slots_;  // a power of two; at most half of them are taken
  std::size_t num_free_;     // until it grows
};

}  // namespace fovea
