#include "client/observer/http_types.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <nlohmann/json.hpp>
#include <string_view>

#include "client/observer/json_text.h"

namespace fovea::observer {
namespace {

std::string Value(const std::map<std::string, std::string>& map, const std::string& name) {
  const auto found = map.find(name);
  return found == map.end() ? "" : found->second;
}

int DigitOf(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::optional<std::string> Decode(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += text[i];
      continue;
    }
    const int high = i + 2 < text.size() ? DigitOf(text[i + 1]) : -1;
    const int low = i + 2 < text.size() ? DigitOf(text[i + 2]) : -1;
    if (high < 0 || low < 0) return std::nullopt;
    decoded += static_cast<char>(16 * high + low);
    i += 2;
  }
  return decoded;
}

// Takes "http://HOST" off the front, if that is there, and says the host.
std::optional<std::string> TakeHost(std::string* target) {
  for (const std::string_view scheme : {"http://", "https://"}) {
    const bool is_it = std::ranges::equal(
        std::string_view(*target).substr(0, scheme.size()), scheme,
        [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
    if (!is_it) continue;
    const std::size_t end = std::min(target->find_first_of("/?", scheme.size()), target->size());
    std::string host = target->substr(scheme.size(), end - scheme.size());
    target->erase(0, end);
    if (!target->starts_with('/')) target->insert(0, "/");
    return host;
  }
  return std::nullopt;
}

}  // namespace

std::string HttpRequest::Header(const std::string& name) const { return Value(headers, name); }
std::string HttpRequest::Query(const std::string& name) const { return Value(query, name); }

std::string HttpRequest::Cookie(const std::string& name) const {
  const std::string cookies = Header("cookie");
  std::string_view rest = cookies;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(';'), rest.size());
    std::string_view pair = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    while (pair.starts_with(' ')) pair.remove_prefix(1);
    if (pair.starts_with(name) && pair.substr(name.size()).starts_with('=')) {
      return std::string(pair.substr(name.size() + 1));
    }
  }
  return {};
}

bool ParseTarget(std::string target, HttpRequest* request) {
  if (const auto host = TakeHost(&target)) {
    if (host->empty() || host->find('@') != std::string::npos) return false;
    request->headers["host"] = *host;
  }
  const std::size_t mark = std::min(target.find('?'), target.size());
  const auto path = Decode(std::string_view(target).substr(0, mark));
  if (!path || !path->starts_with('/')) return false;
  request->path = *path;
  std::string_view rest = std::string_view(target).substr(std::min(mark + 1, target.size()));
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('&'), rest.size());
    const std::string_view pair = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const std::size_t sign = std::min(pair.find('='), pair.size());
    const auto name = Decode(pair.substr(0, sign));
    const auto value = Decode(pair.substr(std::min(sign + 1, pair.size())));
    if (!name || !value) return false;
    request->query[*name] = *value;
  }
  return true;
}

std::optional<std::uint64_t> NumberOf(const std::string& text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

HttpResponse BytesResponse(std::string type, std::string bytes) {
  return {.type = std::move(type), .body = std::make_shared<const std::string>(std::move(bytes))};
}

HttpResponse NotFound() { return ErrorResponse(404, "there is nothing here"); }

HttpResponse ErrorResponse(int status, const std::string& text) {
  const nlohmann::json body{{"error", text}};
  return {.status = status, .body = std::make_shared<const std::string>(JsonText(body))};
}

}  // namespace fovea::observer
