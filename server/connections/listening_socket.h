#pragma once

#include <string>

#include "server/connections/file_descriptor.h"

namespace fovea::server {

// An address that is listened on. The file of a UNIX socket goes when this does.
class ListeningSocket {
 public:
  // `address` is HOST:PORT (port 0 takes a free one; "0.0.0.0" is IPv4 only, "[::]" both), or
  // "unix:/PATH", which this user and its group may then connect to. Throws std::runtime_error with
  // the address and the reason where it cannot be listened on; so it does for an address on which
  // another process listens.
  explicit ListeningSocket(const std::string& address);
  ~ListeningSocket();

  ListeningSocket(ListeningSocket&&) = default;
  ListeningSocket& operator=(ListeningSocket&&) = delete;

  int fd() const { return fd_.get(); }
  // As given, with the real port.
  const std::string& address() const { return address_; }

 private:
  FileDescriptor fd_;
  std::string address_;
};

}  // namespace fovea::server
