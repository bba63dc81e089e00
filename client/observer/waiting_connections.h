#pragma once

#include <boost/beast/core/tcp_stream.hpp>
#include <cstdint>
#include <map>

namespace fovea::observer {

// Connections that wait for a request, or for the rest of one: who closes them takes no answer from
// anybody. Of one thread.
class WaitingConnections {
 public:
  // As long as this lives, its connection waits.
  class Place {
   public:
    Place(WaitingConnections& all, boost::beast::tcp_stream& stream)
        : all_(all), number_(all.next_++) {
      all_.streams_[number_] = &stream;
    }
    ~Place() { all_.streams_.erase(number_); }

    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

   private:
    WaitingConnections& all_;
    const std::uint64_t number_;
  };

  // That which has waited for longest; false where none waits.
  bool CloseOldest() {
    if (streams_.empty()) return false;
    streams_.begin()->second->close();
    streams_.erase(streams_.begin());
    return true;
  }

 private:
  std::uint64_t next_ = 0;
  std::map<std::uint64_t, boost::beast::tcp_stream*> streams_;  // by when they began to wait
};

}  // namespace fovea::observer
