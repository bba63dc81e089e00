// A small HTTP server for whoever watches: GET and nothing else, one request a connection.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace fovea::server {

struct HttpAnswer {
  int status = 200;
  std::string content_type = "text/plain; charset=utf-8";
  std::string body;
};

// One thread serves all connections, none of which it waits for: a caller that sends or reads
// slowly holds nobody up. A request has 2 s and 8 KiB, an answer 10 s; of more than 64 connections
// (an eighth of the files that may be open, where that is less) the oldest is closed, so that a
// flood of idle ones cannot keep a new one from its answer.
class HttpServer {
 public:
  // Called on that thread with the path, without its query. What it throws is answered with 500.
  using Handler = std::function<HttpAnswer(std::string_view path)>;

  // `listen` is HOST:PORT, port 0 takes a free one. Throws std::runtime_error that starts with
  // `flag` where it cannot be listened on.
  HttpServer(const char* flag, const std::string& listen, Handler handler);
  ~HttpServer();

  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  // HOST:PORT with the real port.
  std::string Address() const;

 private:
  class Impl;
  const std::unique_ptr<Impl> impl_;
};

}  // namespace fovea::server
