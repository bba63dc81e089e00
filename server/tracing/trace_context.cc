#include "server/tracing/trace_context.h"

#include <algorithm>
#include <charconv>
#include <random>
#include <span>

namespace fovea::server {
namespace {

constexpr std::size_t kTraceAt = 3, kParentAt = 36, kFlagsAt = 53, kSize = 55;

bool IsHex(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); }

bool IsZero(std::span<const std::uint8_t> bytes) {
  return std::ranges::all_of(bytes, [](std::uint8_t byte) { return byte == 0; });
}

bool HasFormat(std::string_view text) {
  if (text.size() < kSize || text.starts_with("ff")) return false;
  for (std::size_t i = 0; i < kSize; ++i) {
    const bool is_dash = i == kTraceAt - 1 || i == kParentAt - 1 || i == kFlagsAt - 1;
    if (is_dash ? text[i] != '-' : !IsHex(text[i])) return false;
  }
  // Later versions may say more behind a dash.
  return text.size() == kSize || (!text.starts_with("00") && text[kSize] == '-');
}

void Read(std::string_view digits, std::span<std::uint8_t> bytes) {
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::from_chars(digits.data() + 2 * i, digits.data() + 2 * i + 2, bytes[i], 16);
  }
}

std::string Hex(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}

std::mt19937_64& Random() {
  thread_local std::mt19937_64 random = [] {
    std::random_device device;
    std::seed_seq seed{device(), device(), device(), device(), device(), device()};
    return std::mt19937_64(seed);
  }();
  return random;
}

template <typename Id>
Id RandomId() {
  Id id{};
  while (IsZero(id)) {
    std::ranges::generate(id, [] { return static_cast<std::uint8_t>(Random()()); });
  }
  return id;
}

}  // namespace

std::optional<TraceContext> ParseTraceparent(std::string_view text) {
  if (!HasFormat(text)) return std::nullopt;
  TraceContext context;
  std::array<std::uint8_t, 1> flags{};
  Read(text.substr(kTraceAt), context.trace_id);
  Read(text.substr(kParentAt), context.parent);
  Read(text.substr(kFlagsAt), flags);
  context.sampled = (flags[0] & 1) != 0;
  if (IsZero(context.trace_id) || IsZero(context.parent)) return std::nullopt;
  return context;
}

std::string HexOf(const TraceId& id) { return Hex(id); }
std::string HexOf(const SpanId& id) { return Hex(id); }

TraceId RandomTraceId() { return RandomId<TraceId>(); }
SpanId RandomSpanId() { return RandomId<SpanId>(); }

double RandomShare() { return std::uniform_real_distribution<double>()(Random()); }

}  // namespace fovea::server
