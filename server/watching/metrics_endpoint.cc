#include "server/watching/metrics_endpoint.h"

#include <stdexcept>

#include "server/server_options.h"

namespace fovea::server {

MetricsEndpoint::MetricsEndpoint(const std::string& listen, const std::shared_ptr<Metrics>& metrics)
    : host_(HostOf(listen)) {
  try {
    exposer_ = std::make_unique<prometheus::Exposer>(listen, /*num_threads=*/1);
  } catch (const std::exception&) {  // whose text is about "null context"
    throw std::runtime_error("--metrics-listen: cannot listen on " + listen +
                             ": the port is in use or the address is not one of this machine");
  }
  exposer_->RegisterCollectable(metrics);
}

std::string MetricsEndpoint::Address() const {
  return host_ + ":" + std::to_string(exposer_->GetListeningPorts().front());
}

}  // namespace fovea::server
