// What the routes know of HTTP; the server that speaks it is in http_server.h.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fovea::observer {

struct HttpRequest {
  std::string method = {};
  std::string path = {};                            // decoded, without the query
  std::map<std::string, std::string> query = {};    // decoded
  std::map<std::string, std::string> headers = {};  // names in small letters
  std::string body = {};

  // Empty where there is none.
  std::string Header(const std::string& name) const;
  std::string Query(const std::string& name) const;
  std::string Cookie(const std::string& name) const;
};

// Fills path and query from "/a%20b?c=d", and from "http://HOST/a%20b?c=d" the host, too, in place
// of the header that says it (RFC 9112, 3.2.2); false where that is malformed.
bool ParseTarget(std::string target, HttpRequest* request);

// Events that are sent as they come, as Server-Sent Events.
class EventSource {
 public:
  virtual ~EventSource() = default;
  // What to send now; empty where there is nothing.
  virtual std::string Take() = 0;
  // Whether there will be nothing more.
  virtual bool HasEnded() const = 0;
  // Has `wake` called, from any thread, when there may be something to take. Until this is gone.
  virtual void OnNews(std::function<void()> wake) = 0;
};

struct HttpResponse {
  int status = 200;
  std::string type = "application/json";
  std::shared_ptr<const std::string> body = std::make_shared<const std::string>();
  std::vector<std::pair<std::string, std::string>> headers = {};
  std::shared_ptr<EventSource> events = nullptr;  // instead of a body
};

// Digits alone; none where it is something else, or too large.
std::optional<std::uint64_t> NumberOf(const std::string& text);

HttpResponse BytesResponse(std::string type, std::string bytes);
HttpResponse NotFound();
// {"error": …}.
HttpResponse ErrorResponse(int status, const std::string& text);

}  // namespace fovea::observer
