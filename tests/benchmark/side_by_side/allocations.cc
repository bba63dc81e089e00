#include "tests/benchmark/side_by_side/allocations.h"

#include <malloc.h>

#include <atomic>
#include <cerrno>
#include <cstddef>

namespace {

std::atomic<std::int64_t> num_allocations = 0, num_bytes = 0, peak_bytes = 0;

// glibc's, which stays reachable under these names.
// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming)
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);
}
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)

void* Count(void* block) {
  if (block == nullptr) return block;
  num_allocations.fetch_add(1, std::memory_order_relaxed);
  const auto size = static_cast<std::int64_t>(malloc_usable_size(block));
  const std::int64_t now = num_bytes.fetch_add(size, std::memory_order_relaxed) + size;
  for (std::int64_t peak = peak_bytes.load(std::memory_order_relaxed);
       now > peak && !peak_bytes.compare_exchange_weak(peak, now, std::memory_order_relaxed);) {
  }
  return block;
}

void Forget(void* block) {
  if (block == nullptr) return;
  num_bytes.fetch_sub(static_cast<std::int64_t>(malloc_usable_size(block)),
                      std::memory_order_relaxed);
}

}  // namespace

extern "C" {
void* malloc(std::size_t size) { return Count(__libc_malloc(size)); }
void* calloc(std::size_t count, std::size_t size) { return Count(__libc_calloc(count, size)); }
void* realloc(void* block, std::size_t size) {
  Forget(block);
  return Count(__libc_realloc(block, size));
}
void* memalign(std::size_t alignment, std::size_t size) {
  return Count(__libc_memalign(alignment, size));
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  return Count(__libc_memalign(alignment, size));
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  *block = Count(__libc_memalign(alignment, size));
  return *block == nullptr ? ENOMEM : 0;
}
void free(void* block) {
  Forget(block);
  __libc_free(block);
}
}

namespace fovea::benchmark {

AllocationCounter::AllocationCounter() : count_before_(num_allocations), bytes_before_(num_bytes) {
  peak_bytes = bytes_before_;
}

Allocations AllocationCounter::SoFar() const {
  return {num_allocations - count_before_, peak_bytes - bytes_before_};
}

}  // namespace fovea::benchmark
