#include "client/observer/http_server.h"

#include <atomic>
#include <boost/asio.hpp>
#include <boost/asio/ssl.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/ssl.hpp>
#include <chrono>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>  // Boost.Asio 1.74 forgets it

#include "client/observer/http_sending.h"

namespace fovea::observer {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using asio::awaitable;
using asio::use_awaitable;
using tcp = asio::ip::tcp;
using boost::system::error_code;
using PlainStream = beast::tcp_stream;
using TlsStream = beast::ssl_stream<beast::tcp_stream>;

constexpr std::chrono::seconds kReadTime{60}, kHandshakeTime{5};
constexpr std::chrono::seconds kKeepAlive{15};
constexpr std::chrono::milliseconds kEventPause{30};  // what comes closer together is one event
constexpr std::uint32_t kMaxHeader = 8 << 10;
constexpr std::uint64_t kMaxBody = 64 << 10;

// Only this page's own files are loaded, nothing is guessed, framed or told to others.
constexpr std::pair<const char*, const char*> kSecurityHeaders[]{
    {"Content-Security-Policy",
     "default-src 'self'; img-src 'self' blob:; frame-ancestors 'none'; base-uri 'none'; "
     "form-action 'none'"},
    {"X-Content-Type-Options", "nosniff"},
    {"Referrer-Policy", "no-referrer"},
    {"Cross-Origin-Opener-Policy", "same-origin"},
    {"Cross-Origin-Resource-Policy", "same-origin"}};

// The status line and fields. A stream of events ends with its connection.
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

// Of HOST:PORT, IPv6 in brackets.
tcp::endpoint EndpointOf(const std::string& listen, asio::io_context& context) {
  const std::size_t colon = listen.rfind(':');
  if (colon == std::string::npos) {
    throw std::runtime_error("--listen: \"" + listen + "\" is not HOST:PORT");
  }
  std::string host = listen.substr(0, colon);
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  tcp::resolver resolver(context);
  return *resolver.resolve(host, listen.substr(colon + 1), tcp::resolver::passive).begin();
}

// Wakes a coroutine from any thread; outlives whoever waits.
class Wake : public std::enable_shared_from_this<Wake> {
 public:
  explicit Wake(const asio::any_io_executor& executor) : timer_(executor) {}

  void Call() {
    if (called_.exchange(true)) return;
    asio::post(timer_.get_executor(), [self = shared_from_this()] { self->timer_.cancel(); });
  }
  awaitable<void> Wait(std::chrono::milliseconds patience) {
    timer_.expires_after(patience);
    if (!called_) {
      error_code ignored;
      co_await timer_.async_wait(asio::redirect_error(use_awaitable, ignored));
    }
    called_ = false;
  }

 private:
  asio::steady_timer timer_;
  std::atomic<bool> called_ = false;
};

template <typename Stream>
awaitable<void> SendEvents(Stream& stream, const HttpResponse& response, unsigned version) {
  const std::string head = HeadOf(response, version, false);
  co_await Send(stream, head);
  const auto executor = co_await asio::this_coro::executor;
  const auto wake = std::make_shared<Wake>(executor);
  response.events->OnNews([wake] { wake->Call(); });
  // A browser that leaves is noticed at once, so that nothing more is asked of servers for it.
  const auto has_left = std::make_shared<bool>(false);
  beast::get_lowest_layer(stream).socket().async_wait(tcp::socket::wait_read,
                                                      [wake, has_left](error_code) {
                                                        *has_left = true;
                                                        wake->Call();
                                                      });
  asio::steady_timer pause(executor);
  while (!*has_left) {
    const std::string text = response.events->Take();
    if (!text.empty()) {
      co_await Send(stream, text);
      if (response.events->HasEnded()) co_return;
      pause.expires_after(kEventPause);
      co_await pause.async_wait(use_awaitable);
      co_await wake->Wait(kKeepAlive);
      continue;
    }
    co_await Send(stream, ": nothing new\n\n");  // one that left without a word is noticed, too
    co_await wake->Wait(kKeepAlive);
  }
}

}  // namespace

class HttpServer::Impl {
 public:
  Impl(const HttpOptions& options, Handler handler)
      : handler_(std::move(handler)), max_connections_(options.max_connections) {
    if (!options.certificate.empty()) {
      tls_.emplace(asio::ssl::context::tls_server);
      tls_->set_options(asio::ssl::context::default_workarounds | asio::ssl::context::no_tlsv1 |
                        asio::ssl::context::no_tlsv1_1);
      tls_->use_certificate_chain(asio::buffer(options.certificate));
      tls_->use_private_key(asio::buffer(options.key), asio::ssl::context::pem);
    }
    const tcp::endpoint endpoint = EndpointOf(options.listen, context_);
    acceptor_.open(endpoint.protocol());
    acceptor_.set_option(asio::socket_base::reuse_address(true));
    acceptor_.bind(endpoint);
    acceptor_.listen();
  }

  std::string Address() const {
    const tcp::endpoint endpoint = acceptor_.local_endpoint();
    const std::string host = endpoint.address().to_string();
    return (endpoint.address().is_v6() ? "[" + host + "]" : host) + ":" +
           std::to_string(endpoint.port());
  }

  void Run() {
    asio::signal_set signals(context_, SIGTERM, SIGINT);
    signals.async_wait([this](error_code, int) { context_.stop(); });
    asio::co_spawn(context_, Accept(), asio::detached);
    context_.run();
    slow_.join();
  }

 private:
  awaitable<void> Accept() {
    while (true) {
      error_code error;
      tcp::socket socket =
          co_await acceptor_.async_accept(asio::redirect_error(use_awaitable, error));
      if (error || num_connections_ >= max_connections_) {
        asio::steady_timer pause(context_, std::chrono::milliseconds(error ? 100 : 1));
        co_await pause.async_wait(asio::redirect_error(use_awaitable, error));
        continue;  // the socket closes
      }
      ++num_connections_;
      asio::co_spawn(context_, Serve(std::move(socket)), [this](const std::exception_ptr&) {
        --num_connections_;  // whatever ended it: the peer left, stalled, or spoke no HTTP
      });
    }
  }

  awaitable<void> Serve(tcp::socket socket) {
    if (!tls_) {
      PlainStream stream(std::move(socket));
      co_await Converse(stream);
      co_return;
    }
    TlsStream stream(std::move(socket), *tls_);
    beast::get_lowest_layer(stream).expires_after(kHandshakeTime);
    co_await stream.async_handshake(asio::ssl::stream_base::server, use_awaitable);
    co_await Converse(stream);
  }

  template <typename Stream>
  awaitable<void> Converse(Stream& stream) {
    beast::flat_buffer buffer(kMaxHeader + kMaxBody);
    bool goes_on = true;
    while (goes_on) {
      http::request_parser<http::string_body> parser;
      parser.header_limit(kMaxHeader);
      parser.body_limit(kMaxBody);
      beast::get_lowest_layer(stream).expires_after(kReadTime);
      co_await http::async_read(stream, buffer, parser, use_awaitable);
      const http::request<http::string_body> message = parser.release();
      const bool is_head = message.method() == http::verb::head;
      bool is_good = false;
      const HttpRequest request = RequestOf(message, &is_good);
      // No co_await in a conditional expression: GCC 12 destroys what that yields twice.
      HttpResponse response = ErrorResponse(400, "the address is malformed");
      if (is_good) response = co_await Answer(request);
      if (response.events && !is_head) {
        co_await SendEvents(stream, response, message.version());
        co_return;
      }
      goes_on = message.keep_alive();
      const std::string head = HeadOf(response, message.version(), goes_on);
      co_await Send(stream, head, is_head ? std::string_view() : *response.body);
    }
  }

  awaitable<HttpResponse> Answer(const HttpRequest& request) {
    if (!handler_.is_slow(request)) co_return handler_.answer(request);
    const auto answer = [this, &request]() -> awaitable<HttpResponse> {
      co_return handler_.answer(request);
    };
    co_return co_await asio::co_spawn(slow_, answer, use_awaitable);
  }

  const Handler handler_;
  const int max_connections_;
  int num_connections_ = 0;
  asio::io_context context_{1};
  asio::thread_pool slow_{8};
  std::optional<asio::ssl::context> tls_;
  tcp::acceptor acceptor_{context_};
};

HttpServer::HttpServer(const HttpOptions& options, Handler handler)
    : impl_(std::make_unique<Impl>(options, std::move(handler))) {}
HttpServer::~HttpServer() = default;
std::string HttpServer::Address() const { return impl_->Address(); }
void HttpServer::Run() { impl_->Run(); }

}  // namespace fovea::observer
