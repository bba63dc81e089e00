// Threads that help where one frame has parts that do not depend on each other, so that it is
// answered sooner on a machine that has nothing else to do.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <list>
#include <mutex>
#include <span>
#include <thread>
#include <vector>

namespace fovea {

using Task = std::function<void()>;

// Calls each task once and returns after the last one. They run side by side where this thread is
// being helped (Helpers::Scope), else in turn. What a task throws is thrown here; where several do,
// that of the first of them. A stop that is asked of this thread reaches all of them.
void RunTogether(std::span<const Task> tasks);
void RunTogether(std::initializer_list<Task> tasks);

// The same for `work` on each number from 0 to `count` - 1.
void ForEachTogether(std::size_t count, const std::function<void(std::size_t)>& work);

// Whether others may work for this thread.
bool IsHelped();

class Helpers {
 public:
  // For `num_cores` that may be busy at once. `set_up`, if given, is called by each helper first.
  explicit Helpers(int num_cores, const std::function<void()>& set_up = {});
  ~Helpers();

  Helpers(const Helpers&) = delete;
  Helpers& operator=(const Helpers&) = delete;

  // From its making to its end this thread is busy, and is helped while fewer are than there are
  // cores. Scopes are not nested.
  class Scope {
   public:
    // No more than `max_threads` work for it at once, itself included.
    Scope(Helpers& helpers, int max_threads);
    ~Scope();

    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    friend class Helpers;
    friend bool IsHelped();
    friend void fovea::RunTogether(std::span<const Task> tasks);

    Helpers& helpers_;
    int spare_;  // helpers that it may still have
  };

  // How long this thread has waited for helpers, since ever.
  static std::chrono::nanoseconds Waited();

 private:
  friend bool IsHelped();
  friend void RunTogether(std::span<const Task> tasks);
  struct Batch;

  void Stop();
  void Run(Scope& scope, std::span<const Task> tasks);
  void Await(Batch& batch, std::unique_lock<std::mutex>& lock);
  Batch* FindPart(const Scope& scope);
  Batch* FindWork();
  static bool HasTasks(const Batch& batch);
  void Help();
  static void RunNext(Batch& batch, std::unique_lock<std::mutex>& lock);

  const int num_cores_;
  std::mutex mutex_;
  std::condition_variable work_, done_;
  std::list<Batch*> open_;  // that have tasks left which nobody has begun
  int num_busy_ = 0;
  bool stopping_ = false;
  std::vector<std::jthread> threads_;  // last: they use all of the above
};

}  // namespace fovea
