// W3C Trace Context: whose part a call is.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fovea::server {

using TraceId = std::array<std::uint8_t, 16>;
using SpanId = std::array<std::uint8_t, 8>;

struct TraceContext {
  TraceId trace_id{};
  SpanId parent{};
  bool sampled = false;  // the caller records its part
};

// Of the metadata `traceparent`, for example
// "00-0af7651916cd43dd8448eb211c80319c-b7ad6b7169203331-01"; empty where it is malformed.
std::optional<TraceContext> ParseTraceparent(std::string_view text);

// In lower case.
std::string HexOf(const TraceId& id);
std::string HexOf(const SpanId& id);

// Never 0.
TraceId RandomTraceId();
SpanId RandomSpanId();

// In [0, 1).
double RandomShare();

}  // namespace fovea::server
