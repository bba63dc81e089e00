#pragma once

#include <string>

namespace fovea::load {

// A TCP connection without gRPC, closed at the end.
class RawConnection {
 public:
  // `address` is HOST:PORT. Throws std::runtime_error where nobody listens.
  explicit RawConnection(const std::string& address);
  ~RawConnection();

  RawConnection(const RawConnection&) = delete;
  RawConnection& operator=(const RawConnection&) = delete;

  // What the other side does not take is lost.
  void Send(const std::string& bytes) const;

 private:
  int socket_;
};

}  // namespace fovea::load
