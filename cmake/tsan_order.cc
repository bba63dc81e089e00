// Tells the thread sanitizer what Debian's libraries, which are built without it, do in order:
// absl::Mutex, absl::CondVar and completion queues, by which gRPC hands calls from thread to
// thread, and the start and end of cv::parallel_for_. Without this, everything that passes through
// them is reported.
//
// Linked before those libraries in builds with -fsanitize=thread only: its functions are called in
// place of theirs and call them in turn.
#include <absl/status/status.h>
#include <absl/synchronization/mutex.h>
#include <dlfcn.h>
#include <grpc/grpc.h>
#include <sanitizer/tsan_interface.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <opencv2/core/utility.hpp>
#include <utility>

namespace {

// The function of that (mangled) name in the library that is shadowed here.
template <typename Function>
Function* Real(const char* name) {
  void* const function = dlsym(RTLD_NEXT, name);
  if (function == nullptr) {
    std::fprintf(stderr, "tsan_order: no library has %s\n", name);
    std::abort();
  }
  return reinterpret_cast<Function*>(function);
}

// gRPC 1.51 looks at connect's errno only after it has taken locks and allocated memory, so what
// stands in for a lock must leave errno alone; finding the real function does not.
class KeepErrno {
 public:
  ~KeepErrno() { errno = errno_; }

 private:
  const int errno_ = errno;
};

// What a part of a loop did comes after what its caller did before, and before what it does next.
class OrderedBody : public cv::ParallelLoopBody {
 public:
  explicit OrderedBody(const cv::ParallelLoopBody& body) : body_(body) {}

  void operator()(const cv::Range& range) const override {
    Acquire();
    body_(range);
    Release();
  }

  void Acquire() const { __tsan_acquire(const_cast<OrderedBody*>(this)); }
  void Release() const { __tsan_release(const_cast<OrderedBody*>(this)); }

 private:
  const cv::ParallelLoopBody& body_;
};

}  // namespace

// Those that gRPC calls; it takes no lock for reading.
namespace absl {
ABSL_NAMESPACE_BEGIN

void Mutex::Lock() {
  const KeepErrno keep;
  static auto* const real = Real<void(Mutex*)>("_ZN4absl7debian35Mutex4LockEv");
  real(this);
  __tsan_acquire(this);
}

bool Mutex::TryLock() {
  const KeepErrno keep;
  static auto* const real = Real<bool(Mutex*)>("_ZN4absl7debian35Mutex7TryLockEv");
  const bool locked = real(this);
  if (locked) __tsan_acquire(this);
  return locked;
}

void Mutex::Unlock() {
  const KeepErrno keep;
  static auto* const real = Real<void(Mutex*)>("_ZN4absl7debian35Mutex6UnlockEv");
  __tsan_release(this);
  real(this);
}

void CondVar::Wait(Mutex* mutex) {
  static auto* const real =
      Real<void(CondVar*, Mutex*)>("_ZN4absl7debian37CondVar4WaitEPNS0_5MutexE");
  __tsan_release(mutex);
  real(this, mutex);
  __tsan_acquire(mutex);
}

bool CondVar::WaitWithTimeout(Mutex* mutex, Duration timeout) {
  static auto* const real = Real<bool(CondVar*, Mutex*, Duration)>(
      "_ZN4absl7debian37CondVar15WaitWithTimeoutEPNS0_5MutexENS0_8DurationE");
  __tsan_release(mutex);
  const bool timed_out = real(this, mutex, timeout);
  __tsan_acquire(mutex);
  return timed_out;
}

bool CondVar::WaitWithDeadline(Mutex* mutex, Time deadline) {
  static auto* const real = Real<bool(CondVar*, Mutex*, Time)>(
      "_ZN4absl7debian37CondVar16WaitWithDeadlineEPNS0_5MutexENS0_4TimeE");
  __tsan_release(mutex);
  const bool timed_out = real(this, mutex, deadline);
  __tsan_acquire(mutex);
  return timed_out;
}

ABSL_NAMESPACE_END
}  // namespace absl

// What is done before an operation ends comes before what is done about it: the tag tells which.
struct grpc_cq_completion;

// NOLINTNEXTLINE(readability-identifier-naming): the name is gRPC's
void grpc_cq_end_op(grpc_completion_queue* queue, void* tag, absl::Status status,
                    void (*done)(void*, grpc_cq_completion*), void* done_argument,
                    grpc_cq_completion* storage, bool internal) {
  static auto* const real = Real<decltype(grpc_cq_end_op)>(
      "_Z14grpc_cq_end_opP21grpc_completion_queuePvN4absl7debian36StatusEPFvS1_P18grpc_cq_"
      "completionES1_S6_b");
  __tsan_release(tag);
  real(queue, tag, std::move(status), done, done_argument, storage, internal);
}

grpc_event grpc_completion_queue_next(grpc_completion_queue* queue, gpr_timespec deadline,
                                      void* reserved) {
  static auto* const real =
      Real<decltype(grpc_completion_queue_next)>("grpc_completion_queue_next");
  const grpc_event event = real(queue, deadline, reserved);
  if (event.type == GRPC_OP_COMPLETE) __tsan_acquire(event.tag);
  return event;
}

grpc_event grpc_completion_queue_pluck(grpc_completion_queue* queue, void* tag,
                                       gpr_timespec deadline, void* reserved) {
  static auto* const real =
      Real<decltype(grpc_completion_queue_pluck)>("grpc_completion_queue_pluck");
  const grpc_event event = real(queue, tag, deadline, reserved);
  if (event.type == GRPC_OP_COMPLETE) __tsan_acquire(tag);
  return event;
}

void cv::parallel_for_(const Range& range, const ParallelLoopBody& body, double nstripes) {
  static auto* const real = Real<void(const Range&, const ParallelLoopBody&, double)>(
      "_ZN2cv13parallel_for_ERKNS_5RangeERKNS_16ParallelLoopBodyEd");
  const OrderedBody ordered(body);
  ordered.Release();
  real(range, ordered, nstripes);
  ordered.Acquire();
}
