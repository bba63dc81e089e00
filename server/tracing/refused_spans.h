#pragma once

#include <cstdint>
#include <string>

namespace fovea::server {

// What a collector did not take of spans that it answered with 2xx.
struct RefusedSpans {
  std::uint64_t count = 0;
  std::string reason;  // in the collector's words
};

// Of an ExportTraceServiceResponse of OTLP in its JSON encoding; none where it is anything else.
RefusedSpans RefusedSpansIn(const std::string& answer);

}  // namespace fovea::server
