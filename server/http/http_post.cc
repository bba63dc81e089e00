#include "server/http/http_post.h"

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <exception>
#include <future>
#include <memory>
#include <stdexcept>
#include <thread>
#include <utility>

namespace fovea::server {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using asio::ip::tcp;
using boost::system::error_code;
using Clock = std::chrono::steady_clock;
using Endpoints = tcp::resolver::results_type;

constexpr std::chrono::milliseconds kSlice{50};

// Nothing ends a look-up of a name. So it has a thread that nobody waits for; what it may still use
// is its own.
std::future<Endpoints> LookUp(const HttpUrl& url) {
  std::promise<Endpoints> promise;
  std::future<Endpoints> found = promise.get_future();
  std::thread([url, promise = std::move(promise)]() mutable {
    try {
      asio::io_context context;
      error_code error;
      promise.set_value(tcp::resolver(context).resolve(url.host, url.port, error));
    } catch (...) {
      promise.set_exception(std::current_exception());
    }
  }).detach();
  return found;
}

class Post {
 public:
  Post(const HttpUrl& url, const std::string& body, Clock::time_point deadline)
      : request_(http::verb::post, url.path, 11, body), deadline_(deadline) {
    request_.set(http::field::host, url.host);
    request_.set(http::field::content_type, "application/json");
    request_.keep_alive(false);
    request_.prepare_payload();
    response_.body_limit(64 << 10);
  }

  std::string Run(const Endpoints& endpoints, const std::function<bool()>& should_stop) {
    stream_.expires_at(deadline_);
    stream_.async_connect(endpoints, [this](error_code error, const tcp::endpoint&) {
      if (Failed(error)) return;
      http::async_write(stream_, request_, [this](error_code sent, std::size_t) {
        if (Failed(sent)) return;
        http::async_read(stream_, buffer_, response_, [this](error_code read, std::size_t) {
          if (!Failed(read)) Judge();
        });
      });
    });
    while (!context_.stopped() && !should_stop()) context_.run_one_for(kSlice);
    return result_;
  }

 private:
  bool Failed(error_code error) {
    if (error) result_ = error.message();
    return static_cast<bool>(error);
  }

  void Judge() {
    const unsigned status = response_.get().result_int();
    result_ = status / 100 == 2 ? "" : "HTTP status " + std::to_string(status);
  }

  http::request<http::string_body> request_;
  const Clock::time_point deadline_;
  asio::io_context context_;
  beast::tcp_stream stream_{context_};
  beast::flat_buffer buffer_;
  http::response_parser<http::string_body> response_;
  std::string result_ = "was given up";
};

}  // namespace

HttpUrl ParseHttpUrl(const char* flag, const std::string& text) {
  const auto fail = [&] {
    throw std::invalid_argument(std::string(flag) + ": \"" + text +
                                "\" is not http://HOST[:PORT][/PATH]");
  };
  const std::string scheme = "http://";
  if (!text.starts_with(scheme)) fail();
  const std::size_t slash = text.find('/', scheme.size());
  const std::string authority = text.substr(scheme.size(), slash - scheme.size());
  HttpUrl url;
  if (slash != std::string::npos) url.path = text.substr(slash);
  const bool in_brackets = authority.starts_with('[');
  const std::size_t host_end =
      in_brackets ? authority.find(']') + 1 : std::min(authority.find(':'), authority.size());
  url.host = in_brackets ? authority.substr(1, host_end - 2) : authority.substr(0, host_end);
  const std::string rest = authority.substr(host_end);
  if (!rest.empty()) url.port = rest.substr(1);
  const bool digits = url.port.find_first_not_of("0123456789") == std::string::npos;
  const bool is_port = digits && !url.port.empty() && url.port.size() <= 5 &&
                       std::stoi(url.port) > 0 && std::stoi(url.port) <= 65535;
  if (url.host.empty() || !is_port || (!rest.empty() && rest.front() != ':')) fail();
  if (text.find_first_of(" \t\r\n") != std::string::npos) fail();
  return url;
}

std::string PostJson(const HttpUrl& url, const std::string& body, std::chrono::milliseconds timeout,
                     const std::function<bool()>& should_stop) {
  const Clock::time_point deadline = Clock::now() + timeout;
  std::future<Endpoints> endpoints = LookUp(url);
  while (endpoints.wait_for(kSlice) != std::future_status::ready) {
    if (should_stop() || Clock::now() >= deadline) return "its name is still being looked up";
  }
  const Endpoints found = endpoints.get();
  if (found.empty()) return "its name is not known";
  return Post(url, body, deadline).Run(found, should_stop);
}

}  // namespace fovea::server
