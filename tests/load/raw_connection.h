#pragma once

#include <memory>
#include <string>

namespace fovea::load {

// A TCP connection without gRPC, closed at the end.
class RawConnection {
 public:
  // `address` is HOST:PORT. Throws std::runtime_error where nobody listens.
  explicit RawConnection(const std::string& address);
  // One that is there already.
  static std::unique_ptr<RawConnection> Adopt(int socket);
  ~RawConnection();

  RawConnection(const RawConnection&) = delete;
  RawConnection& operator=(const RawConnection&) = delete;

  // What the other side does not take is lost.
  void Send(const std::string& bytes) const;

  int file() const { return socket_; }

 private:
  RawConnection() = default;

  int socket_ = -1;
};

}  // namespace fovea::load
