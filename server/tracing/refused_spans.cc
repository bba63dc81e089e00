#include "server/tracing/refused_spans.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

namespace fovea::server {
namespace {

using nlohmann::json;

// Numbers of 64 bits are texts in JSON of protobuf, or numbers.
std::uint64_t CountOf(const json& value) {
  constexpr double kMost = 1e15;
  if (value.is_number()) {
    return static_cast<std::uint64_t>(std::clamp(value.get<double>(), 0.0, kMost));
  }
  std::uint64_t count = 0;
  if (value.is_string()) {
    const auto& text = value.get_ref<const std::string&>();
    std::from_chars(text.data(), text.data() + text.size(), count);
  }
  return count;
}

}  // namespace

RefusedSpans RefusedSpansIn(const std::string& answer) {
  const json message = json::parse(answer, nullptr, false);
  if (!message.is_object()) return {};
  const auto partial = message.find("partialSuccess");
  if (partial == message.end() || !partial->is_object()) return {};
  RefusedSpans refused;
  if (const auto count = partial->find("rejectedSpans"); count != partial->end()) {
    refused.count = CountOf(*count);
  }
  if (const auto why = partial->find("errorMessage"); why != partial->end() && why->is_string()) {
    refused.reason = why->get<std::string>();
  }
  return refused;
}

}  // namespace fovea::server
