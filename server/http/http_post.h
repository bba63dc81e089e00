#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "server/http/http_url.h"

namespace fovea::server {

struct PostResult {
  std::string problem;  // why it was not taken; empty where it was (2xx)
  std::string body;     // of the answer then
};

// Posts JSON, on a connection of its own. Returns within `timeout`, whatever names, network and the
// other side do, and within 50 ms of `should_stop` turning true.
PostResult PostJson(const HttpUrl& url, const std::string& body, std::chrono::milliseconds timeout,
                    const std::function<bool()>& should_stop);

}  // namespace fovea::server
