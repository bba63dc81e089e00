// A way to the server that is slow, or ends without a word as when a robot drives out of reach.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "tests/load/raw_connection.h"

namespace fovea::load {

// Listens on a free port of loopback and hands on what comes.
class SlowLink {
 public:
  // `server` is HOST:PORT. Towards it go so many bytes a second; 0: as many as it takes.
  SlowLink(std::string server, std::size_t bytes_per_second);
  ~SlowLink();

  SlowLink(const SlowLink&) = delete;
  SlowLink& operator=(const SlowLink&) = delete;

  // HOST:PORT, for a client to connect to.
  std::string Address() const;

  // From now on nothing is handed on, and nobody is told.
  void Cut() { cut_ = true; }

 private:
  void Accept();
  void HandOn(int from, int to, std::size_t bytes_per_second) const;

  const std::string server_;
  const std::size_t bytes_per_second_;
  const std::unique_ptr<RawConnection> listener_;
  int port_ = 0;
  std::atomic<bool> cut_ = false, stopping_ = false;
  std::vector<std::unique_ptr<RawConnection>> connections_;
  std::vector<std::jthread> ways_;  // two of each connection
  std::jthread accepting_;          // last: it uses all of the above
};

}  // namespace fovea::load
