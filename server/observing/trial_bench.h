#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>

namespace fovea::server {

// Computes what people try, one after the other, on a thread that gives way to all others: robots
// notice nothing. Bounded. Thread-safe.
class TrialBench {
 public:
  struct Limits {
    std::size_t at_once = 4;        // computed or waiting
    std::size_t of_one_person = 2;  // of those
  };

  TrialBench() : TrialBench(Limits{}) {}
  explicit TrialBench(Limits limits);
  // What still waits is dropped; nobody may wait in Run() any more.
  ~TrialBench();

  TrialBench(const TrialBench&) = delete;
  TrialBench& operator=(const TrialBench&) = delete;

  // Has `work` done and returns after that. Throws Overloaded at once where too many are tried.
  void Run(const std::string& person, const std::function<void()>& work);

  std::size_t num_done() const;

 private:
  struct Trial {
    std::string person;
    std::function<void()> work;
    bool done = false;
  };

  void RunThread(const std::stop_token& stop);

  const Limits limits_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<Trial*> waiting_;
  std::map<std::string, std::size_t> by_person_;  // computed or waiting
  std::size_t num_held_ = 0, num_done_ = 0;
  double mean_s_ = 1;  // a guess until there is something to go by
  std::jthread thread_;
};

}  // namespace fovea::server
