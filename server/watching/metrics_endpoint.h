#pragma once

#include <functional>
#include <memory>
#include <string>

#include "server/http/http_server.h"
#include "server/watching/metrics.h"

namespace fovea::server {

// What probes ask for; called from any thread, must answer at once.
struct Health {
  std::function<bool()> is_live;   // the process does its work; else it should be started again
  std::function<bool()> is_ready;  // calls are welcome here
};

// Over HTTP, for Prometheus to scrape and for probes that speak no gRPC: GET /metrics, /livez and
// /readyz, the latter two with 200 for yes and 503 for no.
class MetricsEndpoint {
 public:
  // `listen` is HOST:PORT, port 0 takes a free one. Throws std::runtime_error where it cannot be
  // listened on.
  MetricsEndpoint(const std::string& listen, std::shared_ptr<const Metrics> metrics, Health health);

  // HOST:PORT with the real port.
  std::string Address() const { return server_.Address(); }

 private:
  HttpServer server_;
};

}  // namespace fovea::server
