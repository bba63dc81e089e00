// HTTP on loopback, byte by byte.
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <string>

namespace fovea::testing {

class HttpConnection {
 public:
  explicit HttpConnection(const std::string& address) {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    to.sin_port =
        htons(static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1))));
    EXPECT_EQ(connect(socket_, reinterpret_cast<const sockaddr*>(&to), sizeof to), 0);
  }
  ~HttpConnection() { close(socket_); }

  HttpConnection(const HttpConnection&) = delete;
  HttpConnection& operator=(const HttpConnection&) = delete;

  // False once the other side is gone.
  bool Send(const std::string& text) const {
    return send(socket_, text.data(), text.size(), MSG_NOSIGNAL) ==
           static_cast<ssize_t>(text.size());
  }

  // Until the other side ends the connection.
  std::string ReadAll() const {
    std::string answer;
    char buffer[4096];
    for (ssize_t size; (size = read(socket_, buffer, sizeof buffer)) > 0;) {
      answer.append(buffer, static_cast<std::size_t>(size));
    }
    return answer;
  }

 private:
  const int socket_ = socket(AF_INET, SOCK_STREAM, 0);
};

inline std::string HttpGet(const std::string& address, const std::string& path) {
  const HttpConnection connection(address);
  EXPECT_TRUE(connection.Send("GET " + path + " HTTP/1.0\r\n\r\n"));
  return connection.ReadAll();
}

}  // namespace fovea::testing
