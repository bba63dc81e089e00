#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

namespace fovea::server {

struct HttpUrl {
  std::string host;  // without brackets
  std::string port = "80";
  std::string path = "/";
};

// "http://HOST[:PORT][/PATH]". Throws std::invalid_argument that starts with `flag`.
HttpUrl ParseHttpUrl(const char* flag, const std::string& text);

// Posts JSON, on a connection of its own. Empty where it was taken (2xx), else why not. Returns
// within `timeout`, whatever names, network and the other side do, and within 50 ms of
// `should_stop` turning true.
std::string PostJson(const HttpUrl& url, const std::string& body, std::chrono::milliseconds timeout,
                     const std::function<bool()>& should_stop);

}  // namespace fovea::server
