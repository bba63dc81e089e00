#include "client/observer/routes.h"

#include <algorithm>
#include <exception>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "client/observer/assets.h"
#include "client/observer/board_events.h"
#include "client/observer/board_json.h"
#include "client/observer/exif.h"
#include "client/observer/json_text.h"

namespace fovea::observer {
namespace {

constexpr std::size_t kMaxToken = 256, kMaxRobot = 1024;

std::string InSmallLetters(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

// The name without the port, in small letters; IPv6 keeps its brackets.
std::string NameOfHost(const std::string& host) {
  const std::size_t bracket = host.rfind(']');
  const std::size_t colon = host.find(':', bracket == std::string::npos ? 0 : bracket);
  return InSmallLetters(host.substr(0, colon));
}

// Cookies know hosts, but no ports: that of another observer there has another name.
std::string CookieNameOf(const HttpRequest& request) {
  const std::string host = request.Header("host");
  const std::string port = host.substr(std::min(NameOfHost(host).size() + 1, host.size()));
  const bool is_number = std::ranges::all_of(port, [](char c) { return c >= '0' && c <= '9'; });
  return port.empty() || !is_number ? "fovea_session" : "fovea_session_" + port;
}

std::string TokenIn(const std::string& body) {
  const auto parsed = nlohmann::json::parse(body, nullptr, /*allow_exceptions=*/false);
  if (!parsed.is_object() || !parsed.contains("token") || !parsed["token"].is_string()) return {};
  std::string token = parsed["token"];
  const bool can_be_sent = token.size() <= kMaxToken &&
                           std::ranges::all_of(token, [](char c) { return c > ' ' && c <= '~'; });
  return can_be_sent ? token : "";
}

HttpResponse AssetResponse(const std::string& path) {
  const auto asset = FindAsset(path == "/" ? "/index.html" : path);
  if (!asset) return NotFound();
  HttpResponse response{.type = asset->type, .body = asset->gzip};
  response.headers = {{"Content-Encoding", "gzip"}, {"Cache-Control", "no-cache"}};
  return response;
}

}  // namespace

Routes::Routes(std::vector<ServerLink> servers, std::vector<std::string> hosts,
               Encryption encryption, const HistoryRoutes& history)
    : sessions_(std::move(servers), history.history()),
      history_(history),
      asks_(history),
      hosts_(std::move(hosts)),
      encryption_(encryption) {
  std::ranges::transform(hosts_, hosts_.begin(), InSmallLetters);
}

bool Routes::IsSlow(const HttpRequest& request) {
  return request.path == "/api/login" || HistoryRoutes::IsOne(request.path) ||
         AskRoutes::IsOne(request.path);
}

HttpResponse Routes::Answer(const HttpRequest& request) {
  try {
    return Route(request);
  } catch (const std::exception&) {
    return ErrorResponse(500, "internal error");
  }
}

bool Routes::IsOwnHost(const std::string& host) const {
  return std::ranges::find(hosts_, NameOfHost(host)) != hosts_.end();
}

bool Routes::IsOwnOrigin(const HttpRequest& request) const {
  const std::string origin = request.Header("origin"), host = request.Header("host");
  return (encryption_ != Encryption::kOwn && origin == "http://" + host) ||
         (encryption_ != Encryption::kNone && origin == "https://" + host);
}

HttpResponse Routes::Route(const HttpRequest& request) {
  if (!IsOwnHost(request.Header("host"))) {
    return ErrorResponse(421, "this server is not known by this name; see --host");
  }
  // HEAD is answered as GET; the server leaves the body out.
  const bool is_get = request.method == "GET" || request.method == "HEAD";
  const bool is_post = request.method == "POST";
  if (!is_get && !is_post) {
    HttpResponse response = ErrorResponse(405, "only GET, HEAD and POST are served");
    response.headers.emplace_back("Allow", "GET, HEAD, POST");
    return response;
  }
  if (is_post && !IsOwnOrigin(request)) {
    return ErrorResponse(403, "the request comes from another page");
  }
  if (is_post && request.path == "/api/login") return LogIn(request);
  if (is_get && !request.path.starts_with("/api/")) return AssetResponse(request.path);
  const auto session = sessions_.Find(request.Cookie(CookieNameOf(request)));
  if (!session) return ErrorResponse(401, "log in with an observer's token");
  if (is_post && request.Header("x-fovea-csrf") != session->csrf) {
    return ErrorResponse(403, "the request does not come from the page");
  }
  if (AskRoutes::IsOne(request.path)) return asks_.Answer(request, *session->feed);
  if (is_post) return request.path == "/api/logout" ? LogOut(request, *session) : NotFound();
  if (request.path == "/api/session") return Who(*session);
  if (request.path == "/api/events") return Events(request, *session);
  if (HistoryRoutes::IsOne(request.path)) return history_.Answer(request, session->feed->board());
  return OfFrame(request, *session);
}

std::string Routes::CookieOf(const HttpRequest& request, const std::string& id, bool ends) const {
  // By which browsers say how they came; other pages have been refused.
  const bool is_secure = request.Header("origin").starts_with("https://");
  return CookieNameOf(request) + "=" + id + "; Path=/; HttpOnly; SameSite=Strict" +
         (is_secure ? "; Secure" : "") + (ends ? "; Max-Age=0" : "");
}

HttpResponse Routes::LogIn(const HttpRequest& request) {
  const std::string token = TokenIn(request.body);
  if (token.empty()) return ErrorResponse(400, "token: must be 1 to 256 printable characters");
  std::string problem;
  const auto session = sessions_.LogIn(token, &problem);
  if (!session) return ErrorResponse(401, problem);
  sessions_.LogOut(request.Cookie(CookieNameOf(request)));  // the browser forgets that one
  HttpResponse response = Who(*session);
  response.headers.emplace_back("Set-Cookie", CookieOf(request, session->id, /*ends=*/false));
  return response;
}

HttpResponse Routes::LogOut(const HttpRequest& request, const Session& session) {
  sessions_.LogOut(session.id);
  HttpResponse response = BytesResponse("application/json", "{}");
  response.headers.emplace_back("Set-Cookie", CookieOf(request, "", /*ends=*/true));
  return response;
}

HttpResponse Routes::Who(const Session& session) const {
  auto who = nlohmann::json::parse(session.feed->board().Who().value_or("{}"));
  who["csrf"] = session.csrf;
  who["history"] = nlohmann::json::parse(history_.About());
  return BytesResponse("application/json", JsonText(who));
}

HttpResponse Routes::Events(const HttpRequest& request, const Session& session) const {
  const std::string close = request.Query("close");
  if (close.size() > kMaxRobot) return NotFound();
  HttpResponse response{.type = "text/event-stream"};
  response.events = std::make_shared<BoardEvents>(session, close, request.Query("depth") == "1");
  return response;
}

HttpResponse Routes::OfFrame(const HttpRequest& request, const Session& session) const {
  const auto id = NumberOf(request.Query("id"));
  if (!id) return NotFound();
  const ShownFramePtr shown = session.feed->board().Frame(request.Query("robot"), *id);
  if (!shown) return NotFound();
  const v1::WatchedFrame& frame = shown->frame;
  // The text lives in the frame, which the response keeps.
  const auto part = [&](const std::string& bytes) {
    return std::shared_ptr<const std::string>(shown, &bytes);
  };
  if (request.path == "/api/answer") return BytesResponse("application/json", FrameJson(*shown));
  if (request.path == "/api/preview" && !frame.preview().empty()) {
    return {.type = "image/jpeg", .body = part(frame.preview())};
  }
  if (request.path == "/api/picture" && !frame.picture().empty()) {
    return BytesResponse("image/jpeg", WithoutExif(frame.picture()));
  }
  if (request.path == "/api/depth" && frame.has_depth()) {
    HttpResponse response{.type = "application/octet-stream", .body = part(frame.depth().data())};
    response.headers.emplace_back("Content-Encoding", "gzip");
    return response;
  }
  return NotFound();
}

}  // namespace fovea::observer
