#include "core/types/helpers.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <utility>

#include "core/types/cancelled.h"
#include "core/types/interruption.h"

namespace fovea {
namespace {

// Of this thread; null where nobody helps it.
thread_local Helpers::Scope* scope_of_thread = nullptr;
thread_local std::chrono::nanoseconds waited{0};

// How often who waits for helpers looks whether to stop.
constexpr std::chrono::milliseconds kPeriod{1};

// What was stopped because something else was, or by a helper, knows no stage: others come first.
void RethrowFirst(const std::vector<std::exception_ptr>& errors) {
  std::exception_ptr nameless;
  for (const std::exception_ptr& error : errors) {
    if (!error) continue;
    try {
      std::rethrow_exception(error);
    } catch (const Cancelled& cancelled) {
      if (!cancelled.stage.empty()) throw;
      nameless = error;
    }
  }
  if (nameless) std::rethrow_exception(nameless);
}

}  // namespace

// Tasks of one call of RunTogether(); all but the tasks themselves under the mutex.
struct Helpers::Batch {
  Batch(Scope& of, std::span<const Task> all) : scope(of), tasks(all), errors(all.size()) {}

  Scope& scope;
  const std::span<const Task> tasks;
  std::vector<std::exception_ptr> errors;  // of each task
  std::size_t next = 0;                    // the first that nobody has begun
  std::size_t num_done = 0;
  std::atomic<bool> cancelled = false;
};

Helpers::Helpers(int num_cores, const std::function<void()>& set_up) : num_cores_(num_cores) {
  try {
    for (int i = 1; i < num_cores; ++i) {
      threads_.emplace_back([this, set_up] {
        if (set_up) set_up();
        Help();
      });
    }
  } catch (...) {  // those that there are would be waited for
    Stop();
    throw;
  }
}

Helpers::~Helpers() { Stop(); }

void Helpers::Stop() {
  const std::lock_guard lock(mutex_);
  stopping_ = true;
  work_.notify_all();
}

Helpers::Scope::Scope(Helpers& helpers, int max_threads)
    : helpers_(helpers), spare_(max_threads - 1) {
  const std::lock_guard lock(helpers_.mutex_);
  ++helpers_.num_busy_;
  scope_of_thread = this;
}

Helpers::Scope::~Scope() {
  scope_of_thread = nullptr;
  const std::lock_guard lock(helpers_.mutex_);
  --helpers_.num_busy_;
  helpers_.work_.notify_one();
}

std::chrono::nanoseconds Helpers::Waited() { return waited; }

void Helpers::Run(Scope& scope, std::span<const Task> tasks) {
  Batch batch(scope, tasks);
  std::unique_lock lock(mutex_);
  const auto place = open_.insert(open_.end(), &batch);
  // Where all cores are busy nobody is woken in vain.
  const int free =
      std::min({num_cores_ - num_busy_, scope.spare_, static_cast<int>(tasks.size()) - 1});
  for (int i = 0; i < free; ++i) work_.notify_one();
  done_.notify_all();  // who waits for a part of this frame may help as well
  while (HasTasks(batch)) RunNext(batch, lock);
  open_.erase(place);
  Await(batch, lock);
  lock.unlock();
  RethrowFirst(batch.errors);
}

// Runs the next task, without the lock. Whoever is stopped stops the others.
void Helpers::RunNext(Batch& batch, std::unique_lock<std::mutex>& lock) {
  const std::size_t task = batch.next++;
  lock.unlock();
  std::exception_ptr error;
  try {
    if (batch.cancelled) throw Cancelled();
    batch.tasks[task]();
  } catch (const Cancelled&) {
    error = std::current_exception();
    batch.cancelled = true;
  } catch (...) {  // Run() throws it again
    error = std::current_exception();
  }
  lock.lock();
  batch.errors[task] = std::move(error);
  ++batch.num_done;
}

// Until all tasks are done, whoever waits for them helps with what they have made tasks of.
void Helpers::Await(Batch& batch, std::unique_lock<std::mutex>& lock) {
  std::exception_ptr stopped;
  while (batch.num_done < batch.tasks.size()) {
    if (Batch* part = FindPart(batch.scope); part != nullptr) {
      RunNext(*part, lock);
      done_.notify_all();
      continue;
    }
    const auto began = std::chrono::steady_clock::now();
    done_.wait_for(lock, kPeriod);
    waited += std::chrono::steady_clock::now() - began;
    lock.unlock();
    try {
      if (!stopped) InterruptionPoint();
    } catch (...) {  // whatever it is, helpers still use the batch
      stopped = std::current_exception();
      batch.cancelled = true;
    }
    lock.lock();
  }
  // It knows the stage; what the tasks were stopped by is this.
  if (stopped) batch.errors.front() = stopped;
}

bool Helpers::HasTasks(const Batch& batch) { return batch.next < batch.tasks.size(); }

// The newest batch of a frame with tasks that nobody has begun.
Helpers::Batch* Helpers::FindPart(const Scope& scope) {
  const auto found = std::find_if(open_.rbegin(), open_.rend(), [&](const Batch* batch) {
    return &batch->scope == &scope && HasTasks(*batch);
  });
  return found == open_.rend() ? nullptr : *found;
}

// The oldest batch that may have a helper more.
Helpers::Batch* Helpers::FindWork() {
  if (num_busy_ >= num_cores_) return nullptr;
  const auto found = std::find_if(open_.begin(), open_.end(), [](const Batch* batch) {
    return HasTasks(*batch) && batch->scope.spare_ > 0;
  });
  return found == open_.end() ? nullptr : *found;
}

void Helpers::Help() {
  std::unique_lock lock(mutex_);
  for (;;) {
    Batch* batch = nullptr;
    work_.wait(lock, [&] { return stopping_ || (batch = FindWork()) != nullptr; });
    if (stopping_) return;
    Scope& scope = batch->scope;
    ++num_busy_;
    --scope.spare_;
    {
      const InterruptionScope stop([batch] { return batch->cancelled.load(); });
      scope_of_thread = &scope;  // a task may have tasks of its own
      // One at a time: with the last one done, the batch may be gone.
      RunNext(*batch, lock);
      scope_of_thread = nullptr;
    }
    --num_busy_;
    ++scope.spare_;
    done_.notify_all();
  }
}

bool IsHelped() {
  return scope_of_thread != nullptr && !scope_of_thread->helpers_.threads_.empty();
}

void RunTogether(std::initializer_list<Task> tasks) {
  RunTogether(std::span(tasks.begin(), tasks.size()));
}

void RunTogether(std::span<const Task> tasks) {
  if (IsHelped() && tasks.size() > 1) {
    scope_of_thread->helpers_.Run(*scope_of_thread, tasks);
  } else {
    for (const Task& task : tasks) task();
  }
}

void ForEachTogether(std::size_t count, const std::function<void(std::size_t)>& work) {
  if (!IsHelped()) {
    for (std::size_t i = 0; i < count; ++i) work(i);
    return;
  }
  std::vector<Task> tasks;
  tasks.reserve(count);
  for (std::size_t i = 0; i < count; ++i) tasks.emplace_back([&work, i] { work(i); });
  RunTogether(tasks);
}

}  // namespace fovea
