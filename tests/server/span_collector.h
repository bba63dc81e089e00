// Takes the place of a collector of OpenTelemetry, over HTTP.
#pragma once

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace fovea::testing {

inline std::string Url(const boost::asio::ip::tcp::acceptor& acceptor) {
  return "http://127.0.0.1:" + std::to_string(acceptor.local_endpoint().port()) + "/v1/traces";
}

inline boost::asio::ip::tcp::endpoint FreePort() {
  return {boost::asio::ip::address_v4::loopback(), 0};
}

// Takes what is posted, and answers 200 with `answer`.
class SpanCollector {
 public:
  explicit SpanCollector(std::string answer = "")
      : answer_(std::move(answer)), thread_([this] { Run(); }) {}
  ~SpanCollector() {
    stopping_ = true;
    boost::system::error_code ignored;  // the connection only wakes it
    boost::asio::ip::tcp::socket(context_).connect(acceptor_.local_endpoint(), ignored);
  }

  std::string url() const { return Url(acceptor_); }

  // The spans of the next request.
  std::vector<nlohmann::json> Next() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !requests_.empty(); });
    const nlohmann::json request = nlohmann::json::parse(requests_.front());
    requests_.pop_front();
    resource_ = request.at("resourceSpans").at(0).at("resource");
    return request["resourceSpans"][0].at("scopeSpans").at(0).at("spans");
  }
  const nlohmann::json& resource() const { return resource_; }  // of the last Next()

 private:
  void Run() {
    while (true) {
      boost::asio::ip::tcp::socket socket = acceptor_.accept();
      if (stopping_) return;
      boost::system::error_code error;
      boost::beast::flat_buffer buffer;
      boost::beast::http::request<boost::beast::http::string_body> request;
      boost::beast::http::read(socket, buffer, request, error);
      boost::beast::http::response<boost::beast::http::string_body> response(
          boost::beast::http::status::ok, request.version());
      response.body() = answer_;
      response.prepare_payload();
      boost::beast::http::write(socket, response, error);
      if (request.target() != "/v1/traces") continue;
      const std::lock_guard lock(mutex_);
      requests_.push_back(request.body());
      changed_.notify_one();
    }
  }

  const std::string answer_;
  boost::asio::io_context context_;
  boost::asio::ip::tcp::acceptor acceptor_{context_, FreePort()};
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::string> requests_;
  nlohmann::json resource_;
  std::atomic<bool> stopping_ = false;
  std::jthread thread_;
};

}  // namespace fovea::testing
