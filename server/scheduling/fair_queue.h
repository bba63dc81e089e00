// What waits, by whom it waits for: every key gets its turn, however much others have waiting.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <map>
#include <string>
#include <utility>

namespace fovea::server {

// Round robin between keys, first come first served within one. Not thread-safe. Holds nothing of
// keys that wait for nothing.
template <typename T>
class FairQueue {
 public:
  bool empty() const { return turns_.empty(); }

  void Push(const std::string& key, T item) {
    std::deque<T>& items = waiting_[key];
    if (items.empty()) turns_.push_back(key);
    items.push_back(std::move(item));
  }

  // The queue must not be empty.
  T Pop() {
    const std::string key = std::move(turns_.front());
    turns_.pop_front();
    std::deque<T>& items = waiting_.at(key);
    T item = std::move(items.front());
    items.pop_front();
    if (items.empty()) {
      waiting_.erase(key);
    } else {
      turns_.push_back(key);
    }
    return item;
  }

  // Takes out the first item of `key` that `is_wanted` says yes to; false where there is none.
  template <typename Predicate>
  bool Remove(const std::string& key, Predicate is_wanted) {
    const auto waiting = waiting_.find(key);
    if (waiting == waiting_.end()) return false;
    std::deque<T>& items = waiting->second;
    const auto item = std::find_if(items.begin(), items.end(), is_wanted);
    if (item == items.end()) return false;
    items.erase(item);
    if (items.empty()) {
      waiting_.erase(waiting);
      turns_.erase(std::find(turns_.begin(), turns_.end(), key));
    }
    return true;
  }

 private:
  std::map<std::string, std::deque<T>> waiting_;
  std::deque<std::string> turns_;  // the keys of `waiting_`, next first
};

}  // namespace fovea::server
