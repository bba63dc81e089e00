#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "server/tracing/trace_context.h"

namespace fovea::server {

// Something that took time, as OpenTelemetry has it.
struct Span {
  using Time = std::chrono::time_point<std::chrono::system_clock, std::chrono::nanoseconds>;
  using Value = std::variant<std::string, std::int64_t>;

  std::string name;
  TraceId trace_id{};
  SpanId id{};
  std::optional<SpanId> parent;
  bool is_call = false;  // else a part of one
  Time start, end;
  std::vector<std::pair<std::string, Value>> attributes;
  std::optional<std::string> error;
};

// The spans of one frame.
using FrameSpans = std::vector<Span>;

// An ExportTraceServiceRequest of OTLP in its JSON encoding. What is not UTF-8 is replaced.
std::string OtlpJson(const std::vector<FrameSpans>& frames);

}  // namespace fovea::server
