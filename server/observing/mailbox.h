#pragma once

#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/slice.h>

#include <atomic>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace fovea::server {

// What one watcher has not been sent yet: of each robot the newest frame, in the order in which
// they came. Bounded in bytes. Thread-safe.
class Mailbox {
 public:
  // `total` counts the bytes of all mailboxes; both bounds hold.
  Mailbox(std::size_t max_bytes, std::size_t max_total, std::atomic<std::size_t>& total)
      : max_bytes_(max_bytes), max_total_(max_total), total_(total) {}
  ~Mailbox();

  Mailbox(const Mailbox&) = delete;
  Mailbox& operator=(const Mailbox&) = delete;

  // `message` is a WatchResponse without `dropped`; it takes the place of the robot's one before.
  // False where there is no room.
  bool Put(const std::string& robot, std::uint64_t sequence, const grpc::Slice& message);

  // The next one to send, none where it is empty.
  std::optional<grpc::ByteBuffer> Take();

  // The robot is no longer known.
  void Forget(const std::string& robot);

 private:
  struct Letter {
    std::uint64_t sequence = 0;
    grpc::Slice message;
  };

  void Remove(std::map<std::string, Letter>::iterator letter);  // mutex_ is held

  const std::size_t max_bytes_, max_total_;
  std::atomic<std::size_t>& total_;
  std::mutex mutex_;
  std::size_t bytes_ = 0;
  std::map<std::string, Letter> letters_;
  std::deque<std::string> order_;               // of those
  std::map<std::string, std::uint64_t> taken_;  // the last sequence of each robot
};

}  // namespace fovea::server
