#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <cstdint>
#include <string>

#include "server/connections/file_descriptor.h"

namespace fovea::testing {

// A connection to a loopback address that speaks no gRPC.
class BareConnection {
 public:
  explicit BareConnection(const std::string& address) : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    to.sin_port =
        htons(static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1))));
    EXPECT_EQ(connect(socket_.get(), reinterpret_cast<const sockaddr*>(&to), sizeof to), 0);
  }

  void Send(const std::string& bytes) const {
    EXPECT_EQ(send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(bytes.size()));
  }

  // Whether the other end has not closed it, as far as is known by now.
  bool IsOpen() const {
    char byte = 0;
    return recv(socket_.get(), &byte, 1, MSG_PEEK | MSG_DONTWAIT) != 0;
  }

  // Returns once the other end has closed it.
  void AwaitEnd() const {
    char byte = 0;
    while (recv(socket_.get(), &byte, 1, 0) > 0) {
    }
  }

 private:
  server::FileDescriptor socket_;
};

}  // namespace fovea::testing
