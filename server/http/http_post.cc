#include "server/http/http_post.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <exception>
#include <future>
#include <optional>
#include <string>
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
    request_.set(http::field::host, url.Authority());
    request_.set(http::field::content_type, "application/json");
    request_.keep_alive(false);
    request_.prepare_payload();
  }

  PostResult Run(const Endpoints& endpoints, const std::function<bool()>& should_stop) {
    stream_.expires_at(deadline_);
    stream_.async_connect(endpoints, [this](error_code error, const tcp::endpoint&) {
      if (Failed(error)) return;
      http::async_write(stream_, request_, [this](error_code sent, std::size_t) {
        if (!Failed(sent)) Read();
      });
    });
    while (!context_.stopped() && !should_stop()) context_.run_one_for(kSlice);
    return result_;
  }

 private:
  bool Failed(error_code error) {
    if (error) result_.problem = error.message();
    return static_cast<bool>(error);
  }

  void Read() {
    response_.emplace();
    response_->body_limit(64 << 10);
    http::async_read(stream_, buffer_, *response_, [this](error_code error, std::size_t) {
      if (!Failed(error)) Judge();
    });
  }

  void Judge() {
    const unsigned status = response_->get().result_int();
    // Before the answer, as "100 Continue"; behind 101 comes no HTTP.
    if (status / 100 == 1 && status != 101) return Read();
    if (status / 100 == 2) {
      result_ = {.problem = "", .body = std::move(response_->get().body())};
    } else {
      result_.problem = "HTTP status " + std::to_string(status);
    }
  }

  http::request<http::string_body> request_;
  const Clock::time_point deadline_;
  asio::io_context context_;
  beast::tcp_stream stream_{context_};
  beast::flat_buffer buffer_;
  std::optional<http::response_parser<http::string_body>> response_;
  PostResult result_{.problem = "was given up", .body = ""};
};

}  // namespace

PostResult PostJson(const HttpUrl& url, const std::string& body, std::chrono::milliseconds timeout,
                    const std::function<bool()>& should_stop) {
  const Clock::time_point deadline = Clock::now() + timeout;
  std::future<Endpoints> endpoints = LookUp(url);
  while (endpoints.wait_for(kSlice) != std::future_status::ready) {
    if (should_stop() || Clock::now() >= deadline)
      return {.problem = "its name is still being looked up", .body = ""};
  }
  const Endpoints found = endpoints.get();
  if (found.empty()) return {.problem = "its name is not known", .body = ""};
  return Post(url, body, deadline).Run(found, should_stop);
}

}  // namespace fovea::server
