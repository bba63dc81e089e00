// What waits, by whom it waits for: every key gets its turn, however much others have waiting.
#pragma once

#include <algorithm>
#include <deque>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace fovea::server {

// Round robin between keys, first come first served within one. Not thread-safe. Holds nothing of
// keys that wait for nothing. Taking something out needs no memory, and what finds none to be put
// in changes nothing.
template <typename T>
class FairQueue {
 public:
  bool empty() const { return turns_.empty(); }

  void Push(const std::string& key, T item) {
    if (const auto waiting = waiting_.find(key); waiting != waiting_.end()) {
      waiting->second.push_back(std::move(item));
      return;
    }
    turns_.push_back(key);
    try {
      waiting_[key].push_back(std::move(item));
    } catch (...) {
      waiting_.erase(key);
      turns_.pop_back();
      throw;
    }
  }

  // Of the first key in turn that `may` says yes to; those before it stay where they are. Nothing
  // where there is none.
  template <typename Predicate>
  std::optional<T> Pop(Predicate may) {
    const auto turn = std::find_if(turns_.begin(), turns_.end(), may);
    if (turn == turns_.end()) return std::nullopt;
    const auto waiting = waiting_.find(*turn);
    std::deque<T>& items = waiting->second;
    std::optional<T> item = std::move(items.front());
    items.pop_front();
    if (items.empty()) {
      waiting_.erase(waiting);
      turns_.erase(turn);
    } else {
      std::rotate(turn, std::next(turn), turns_.end());
    }
    return item;
  }

  // The queue must not be empty.
  T Pop() {
    return *Pop([](const std::string&) { return true; });
  }

  // Takes out the first item of `key` that `is_wanted` says yes to; nothing where there is none.
  template <typename Predicate>
  std::optional<T> Remove(const std::string& key, Predicate is_wanted) {
    return Take(key, [&](std::deque<T>& items) {
      return std::find_if(items.begin(), items.end(), is_wanted);
    });
  }

  // The last one.
  template <typename Predicate>
  std::optional<T> RemoveLast(const std::string& key, Predicate is_wanted) {
    return Take(key, [&](std::deque<T>& items) {
      const auto found = std::find_if(items.rbegin(), items.rend(), is_wanted);
      return found == items.rend() ? items.end() : std::prev(found.base());
    });
  }

 private:
  template <typename Find>
  std::optional<T> Take(const std::string& key, Find find) {
    const auto waiting = waiting_.find(key);
    if (waiting == waiting_.end()) return std::nullopt;
    std::deque<T>& items = waiting->second;
    const auto found = find(items);
    if (found == items.end()) return std::nullopt;
    std::optional<T> item = std::move(*found);
    items.erase(found);
    if (items.empty()) {
      waiting_.erase(waiting);
      turns_.erase(std::find(turns_.begin(), turns_.end(), key));
    }
    return item;
  }

  std::map<std::string, std::deque<T>> waiting_;
  std::deque<std::string> turns_;  // the keys of `waiting_`, next first
};

}  // namespace fovea::server
