#pragma once

#include <prometheus/exposer.h>

#include <memory>
#include <string>

#include "server/watching/metrics.h"

namespace fovea::server {

// GET /metrics over HTTP, for Prometheus to scrape.
class MetricsEndpoint {
 public:
  // `listen` is HOST:PORT, port 0 takes a free one. Throws std::runtime_error where it cannot be
  // listened on.
  MetricsEndpoint(const std::string& listen, const std::shared_ptr<Metrics>& metrics);

  // HOST:PORT with the real port.
  std::string Address() const;

 private:
  const std::string host_;
  std::unique_ptr<prometheus::Exposer> exposer_;
};

}  // namespace fovea::server
