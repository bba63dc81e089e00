#include "client/observer/http_messages.h"

#include <cctype>
#include <sstream>
#include <utility>

namespace fovea::observer {

namespace http = boost::beast::http;

namespace {

// Only this page's own files are loaded, nothing is guessed, framed or told to others.
constexpr std::pair<const char*, const char*> kSecurityHeaders[]{
    {"Content-Security-Policy",
     "default-src 'self'; img-src 'self' blob:; frame-ancestors 'none'; base-uri 'none'; "
     "form-action 'none'"},
    {"X-Content-Type-Options", "nosniff"},
    {"Referrer-Policy", "no-referrer"},
    {"Cross-Origin-Opener-Policy", "same-origin"},
    {"Cross-Origin-Resource-Policy", "same-origin"}};

}  // namespace

std::string HeadOf(const HttpResponse& response, unsigned version, bool keep_alive) {
  http::response<http::empty_body> head(static_cast<http::status>(response.status), version);
  head.set(http::field::content_type, response.type);
  head.set(http::field::cache_control, "no-store");
  for (const auto& [name, value] : kSecurityHeaders) head.set(name, value);
  for (const auto& [name, value] : response.headers) head.set(name, value);
  head.keep_alive(keep_alive);
  if (!response.events) head.content_length(response.body->size());
  std::ostringstream text;
  text << head;
  return text.str();
}

HttpRequest RequestOf(const http::request<http::string_body>& message, bool* is_good) {
  HttpRequest request{.method = std::string(message.method_string()), .body = message.body()};
  for (const auto& field : message) {
    std::string name(field.name_string());
    for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    request.headers.emplace(std::move(name), field.value());
  }
  *is_good = ParseTarget(std::string(message.target()), &request);
  return request;
}

}  // namespace fovea::observer
