#pragma once

#include <atomic>
#include <boost/asio.hpp>
#include <boost/beast/core.hpp>
#include <chrono>
#include <memory>
#include <string>
#include <utility>  // Boost.Asio 1.74 forgets it

#include "client/observer/http_messages.h"
#include "client/observer/http_sending.h"
#include "client/observer/http_types.h"

namespace fovea::observer {

constexpr std::chrono::seconds kKeepAlive{5};         // the page waits for three times that
constexpr std::chrono::milliseconds kEventPause{30};  // what comes closer together is one event

// Wakes a coroutine from any thread; outlives whoever waits.
class Wake : public std::enable_shared_from_this<Wake> {
 public:
  explicit Wake(const boost::asio::any_io_executor& executor) : timer_(executor) {}

  void Call() {
    if (called_.exchange(true)) return;
    boost::asio::post(timer_.get_executor(),
                      [self = shared_from_this()] { self->timer_.cancel(); });
  }
  boost::asio::awaitable<void> Wait(std::chrono::milliseconds patience) {
    timer_.expires_after(patience);
    if (!called_) {
      boost::system::error_code ignored;
      co_await timer_.async_wait(boost::asio::redirect_error(boost::asio::use_awaitable, ignored));
    }
    called_ = false;
  }

 private:
  boost::asio::steady_timer timer_;
  std::atomic<bool> called_ = false;
};

// Until they end, or the browser leaves.
template <typename Stream>
boost::asio::awaitable<void> SendEvents(Stream& stream, WaitingConnections& waiting,
                                        const HttpResponse& response, unsigned version) {
  const std::string head = HeadOf(response, version, false);
  co_await Send(stream, waiting, head);
  const auto executor = co_await boost::asio::this_coro::executor;
  const auto wake = std::make_shared<Wake>(executor);
  response.events->OnNews([wake] { wake->Call(); });
  // A browser that leaves is noticed at once, so that nothing more is asked of servers for it.
  const auto has_left = std::make_shared<bool>(false);
  boost::beast::get_lowest_layer(stream).socket().async_wait(
      boost::asio::ip::tcp::socket::wait_read, [wake, has_left](boost::system::error_code) {
        *has_left = true;
        wake->Call();
      });
  boost::asio::steady_timer pause(executor);
  while (!*has_left) {
    const std::string text = response.events->Take();
    if (!text.empty()) {
      co_await Send(stream, waiting, text);
      if (response.events->HasEnded()) co_return;
      pause.expires_after(kEventPause);
      co_await pause.async_wait(boost::asio::use_awaitable);
      co_await wake->Wait(kKeepAlive);
      continue;
    }
    // Whoever left without a word is noticed by it, the observer by the page, too.
    co_await Send(stream, waiting, "event: alive\ndata: {}\n\n");
    co_await wake->Wait(kKeepAlive);
  }
}

}  // namespace fovea::observer
