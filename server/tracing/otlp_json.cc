#include <nlohmann/json.hpp>

#include "server/build_info.h"
#include "server/tracing/span.h"

namespace fovea::server {
namespace {

using nlohmann::json;

// Numbers of 64 bits are texts, as in all JSON of protobuf.
std::string Nanoseconds(Span::Time time) { return std::to_string(time.time_since_epoch().count()); }

json Attribute(const std::string& key, const Span::Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) {
    return {{"key", key}, {"value", {{"stringValue", *text}}}};
  }
  return {{"key", key}, {"value", {{"intValue", std::to_string(std::get<std::int64_t>(value))}}}};
}

json ToJson(const Span& span) {
  constexpr int kInternal = 1, kServer = 2, kError = 2;
  json result{{"traceId", HexOf(span.trace_id)},
              {"spanId", HexOf(span.id)},
              {"name", span.name},
              {"kind", span.is_call ? kServer : kInternal},
              {"startTimeUnixNano", Nanoseconds(span.start)},
              {"endTimeUnixNano", Nanoseconds(span.end)},
              {"attributes", json::array()}};
  if (span.parent) result["parentSpanId"] = HexOf(*span.parent);
  if (span.error) result["status"] = {{"code", kError}, {"message", *span.error}};
  for (const auto& [key, value] : span.attributes) {
    result["attributes"].push_back(Attribute(key, value));
  }
  return result;
}

}  // namespace

std::string OtlpJson(const std::vector<FrameSpans>& frames) {
  json spans = json::array();
  for (const FrameSpans& frame : frames) {
    for (const Span& span : frame) spans.push_back(ToJson(span));
  }
  const json scope{{"scope", {{"name", "fovea"}}}, {"spans", spans}};
  const json resource{
      {"attributes",
       {Attribute("service.name", "fovea-server"), Attribute("service.version", Version())}}};
  const json request{{"resourceSpans", {{{"resource", resource}, {"scopeSpans", {scope}}}}}};
  return request.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace fovea::server
