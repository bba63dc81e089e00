#pragma once

#include <cstdint>
#include <functional>
#include <map>

namespace fovea::observer {

// Connections that wait for their browser: for a request, for the rest of one, or until it takes
// the next piece of an answer. Of one thread.
class WaitingConnections {
 public:
  // As long as this lives, its connection waits.
  class Place {
   public:
    template <typename Connection>
    Place(WaitingConnections& all, Connection& connection) : all_(all), number_(all.next_++) {
      all_.closings_[number_] = [&connection] { connection.close(); };
    }
    ~Place() { all_.closings_.erase(number_); }

    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

   private:
    WaitingConnections& all_;
    const std::uint64_t number_;
  };

  // That which has waited for longest; false where none waits.
  bool CloseOldest() {
    if (closings_.empty()) return false;
    closings_.begin()->second();
    closings_.erase(closings_.begin());
    return true;
  }

 private:
  std::uint64_t next_ = 0;
  std::map<std::uint64_t, std::function<void()>> closings_;  // by when they began to wait
};

}  // namespace fovea::observer
