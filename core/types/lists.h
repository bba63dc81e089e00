// Many lists in one piece of memory.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

namespace fovea {

// A number of lists, which are filled one at a time, or together where their sizes are known.
template <typename Item>
class Lists {
 public:
  Lists() = default;
  explicit Lists(std::size_t count) : bounds_(count) {}

  Lists(std::initializer_list<std::initializer_list<Item>> lists) : bounds_(lists.size()) {
    std::size_t next = 0;
    for (const std::initializer_list<Item>& list : lists) {
      Begin(next++);
      for (const Item& item : list) Add(item);
    }
  }

  // With room for so many items in each.
  static Lists OfSizes(const std::vector<std::size_t>& sizes) {
    Lists lists(sizes.size());
    std::size_t begin = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      lists.bounds_[i] = {begin, begin};
      begin += sizes[i];
    }
    lists.items_.resize(begin);
    return lists;
  }

  // Keeps room for so many items in all.
  void Reserve(std::size_t num_items) { items_.reserve(num_items); }

  // Adds to a list that has room.
  void Put(std::size_t list, const Item& item) { items_[bounds_[list].end++] = item; }

  // Empties a list; all that is added from now on goes there.
  void Begin(std::size_t list) {
    bounds_[list] = {items_.size(), items_.size()};
    open_ = list;
  }
  void Add(const Item& item) {
    items_.push_back(item);
    ++bounds_[open_].end;
  }

  std::size_t size() const { return bounds_.size(); }
  std::span<const Item> operator[](std::size_t list) const {
    return {items_.data() + bounds_[list].begin, bounds_[list].end - bounds_[list].begin};
  }
  std::span<Item> operator[](std::size_t list) {
    return {items_.data() + bounds_[list].begin, bounds_[list].end - bounds_[list].begin};
  }

 private:
  struct Bounds {
    std::size_t begin = 0, end = 0;
  };

  std::vector<Bounds> bounds_;  // of each list in items_
  std::vector<Item> items_;
  std::size_t open_ = 0;
};

}  // namespace fovea
