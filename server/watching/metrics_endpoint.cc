#include "server/watching/metrics_endpoint.h"

#include <prometheus/text_serializer.h>

#include <string_view>
#include <utility>

namespace fovea::server {
namespace {

HttpAnswer Page(const Metrics& metrics) {
  return {.content_type = "text/plain; version=0.0.4; charset=utf-8",
          .body = prometheus::TextSerializer().Serialize(metrics.Collect())};
}

HttpAnswer Probe(bool good, const char* yes, const char* no) {
  return {.status = good ? 200 : 503, .body = good ? yes : no};
}

HttpAnswer Answer(std::string_view path, const Metrics& metrics, const Health& health) {
  if (path == "/metrics") return Page(metrics);
  if (path == "/livez") return Probe(health.is_live(), "live\n", "not live\n");
  if (path == "/readyz") return Probe(health.is_ready(), "ready\n", "not ready\n");
  return {.status = 404, .body = "there are /metrics, /livez and /readyz\n"};
}

}  // namespace

MetricsEndpoint::MetricsEndpoint(const std::string& listen, std::shared_ptr<const Metrics> metrics,
                                 Health health)
    : server_("--metrics-listen", listen,
              [metrics = std::move(metrics), health = std::move(health)](std::string_view path) {
                return Answer(path, *metrics, health);
              }) {}

}  // namespace fovea::server
