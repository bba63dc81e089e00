// What a piece of work asks of the allocator, counted by standing in for malloc and its kin.
#pragma once

#include <cstdint>

namespace fovea::benchmark {

struct Allocations {
  std::int64_t count = 0;
  std::int64_t peak_bytes = 0;  // held at once, beyond what was held before
};

// Of all threads of the process, from its making on. One at a time.
class AllocationCounter {
 public:
  AllocationCounter();
  Allocations SoFar() const;

 private:
  std::int64_t count_before_, bytes_before_;
};

}  // namespace fovea::benchmark
