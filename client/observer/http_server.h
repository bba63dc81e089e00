#pragma once

#include <functional>
#include <memory>
#include <string>

#include "client/observer/http_types.h"

namespace fovea::observer {

struct PemFile {
  std::string path = {}, text = {};
};

// Without text: no TLS.
struct TlsFiles {
  PemFile certificate = {}, key = {};
};

struct HttpOptions {
  std::string listen = "127.0.0.1:8080";  // HOST:PORT, IPv6 in brackets; port 0 takes a free one
  std::function<TlsFiles()> read_tls;     // throws std::runtime_error where they cannot be read
  int max_connections = 256;
};

// Serves HTTP/1.1 on one thread, its caller's, as coroutines that wait for nobody. What is slow
// goes to eight threads of its own. Where there are as many connections as may be, the one that has
// waited longest for its browser makes room, so that a flood of them keeps nobody out.
class HttpServer {
 public:
  struct Handler {
    std::function<bool(const HttpRequest&)> is_slow;
    std::function<HttpResponse(const HttpRequest&)> answer;  // thread-safe, never throws
    std::function<void()> end;  // has answers that are being made come soon
  };

  // Listens when this returns. Throws std::runtime_error that names the flag where it cannot.
  HttpServer(const HttpOptions& options, Handler handler);
  ~HttpServer();

  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  // HOST:PORT with the real port.
  std::string Address() const;

  // Serves until SIGTERM or SIGINT, and for what is slow to end. SIGHUP reads certificate and key
  // again.
  void Run();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace fovea::observer
