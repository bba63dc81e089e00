#include "client/observer/http_server.h"

#include <boost/asio.hpp>
#include <boost/asio/ssl.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/ssl.hpp>
#include <chrono>
#include <cstring>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>  // Boost.Asio 1.74 forgets it

#include "client/observer/http_events.h"
#include "client/observer/http_messages.h"
#include "client/observer/http_sending.h"
#include "client/observer/tls_context.h"
#include "client/observer/waiting_connections.h"

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
using Message = http::request<http::string_body>;

// Of a header, once its connection is new or its first byte has come, of the body behind it, and
// between requests.
constexpr std::chrono::seconds kHeaderTime{5}, kBodyTime{10}, kIdleTime{60};
constexpr std::chrono::seconds kHandshakeTime{5};
constexpr std::uint32_t kMaxHeader = 8 << 10;
constexpr std::uint64_t kMaxBody = 64 << 10;

// Of HOST:PORT, IPv6 in brackets.
tcp::endpoint EndpointOf(const std::string& listen, asio::io_context& context) {
  const std::size_t colon = listen.rfind(':');
  std::string host = listen.substr(0, colon);
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  tcp::resolver resolver(context);
  return *resolver.resolve(host, listen.substr(colon + 1), tcp::resolver::passive).begin();
}

}  // namespace

class HttpServer::Impl {
 public:
  Impl(const HttpOptions& options, Handler handler)
      : options_(options), handler_(std::move(handler)), tls_(ReadTls()) {
    try {
      Listen(options.listen);
    } catch (const boost::system::system_error& error) {
      throw std::runtime_error("--listen: cannot listen on " + options.listen + ": " +
                               error.code().message());
    }
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
    asio::co_spawn(context_, ReadCertificates(), asio::detached);
    asio::co_spawn(context_, SayWhatDoesNothing(), asio::detached);
    asio::co_spawn(context_, Accept(), asio::detached);
    context_.run();
    handler_.end();
    slow_.join();
  }

 private:
  void Listen(const std::string& listen) {
    const tcp::endpoint endpoint = EndpointOf(listen, context_);
    acceptor_.open(endpoint.protocol());
    acceptor_.set_option(asio::socket_base::reuse_address(true));
    acceptor_.bind(endpoint);
    acceptor_.listen();
  }

  std::optional<asio::ssl::context> ReadTls() const {
    const TlsFiles files = options_.read_tls();
    return TlsContextOf(files.certificate, files.key);
  }

  // Again and again, at SIGHUP. Connections that are there keep what they began with.
  awaitable<void> ReadCertificates() {
    while (true) {
      co_await hang_up_.async_wait(use_awaitable);
      try {
        tls_ = ReadTls();
        std::cerr << "fovea-observer: SIGHUP: "
                  << (tls_ ? "certificate and key are read again\n" : "nothing to read again\n");
      } catch (const std::runtime_error& error) {
        std::cerr << "fovea-observer: SIGHUP: " << error.what() << "; all stays as it was\n";
      }
    }
  }

  // They would end the program.
  awaitable<void> SayWhatDoesNothing() {
    while (true) {
      const int signal = co_await without_use_.async_wait(use_awaitable);
      std::cerr << "fovea-observer: SIG" << sigabbrev_np(signal) << " does nothing here\n";
    }
  }

  awaitable<void> Accept() {
    while (true) {
      error_code error;
      tcp::socket socket =
          co_await acceptor_.async_accept(asio::redirect_error(use_awaitable, error));
      const bool is_full = num_connections_ >= options_.max_connections;
      if (error || (is_full && !waiting_.CloseOldest())) {
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
    {
      const WaitingConnections::Place place(waiting_, beast::get_lowest_layer(stream));
      beast::get_lowest_layer(stream).expires_after(kHandshakeTime);
      co_await stream.async_handshake(asio::ssl::stream_base::server, use_awaitable);
    }
    co_await Converse(stream);
  }

  template <typename Stream>
  awaitable<void> Converse(Stream& stream) {
    beast::flat_buffer buffer(kMaxHeader + kMaxBody);
    std::chrono::seconds patience = kHeaderTime;  // with a new connection
    for (bool goes_on = true; goes_on; patience = kIdleTime) {
      const Message message = co_await Read(stream, buffer, patience);
      const bool is_head = message.method() == http::verb::head;
      bool is_good = false;
      const HttpRequest request = RequestOf(message, &is_good);
      // No co_await in a conditional expression: GCC 12 destroys what that yields twice.
      HttpResponse response = ErrorResponse(400, "the address is malformed");
      if (is_good) response = co_await Answer(request);
      if (response.events && !is_head) {
        co_await SendEvents(stream, waiting_, response, message.version());
        co_return;
      }
      goes_on = message.keep_alive();
      const std::string head = HeadOf(response, message.version(), goes_on);
      co_await Send(stream, waiting_, head, is_head ? std::string_view() : *response.body);
    }
  }

  // Waits for its first byte with patience, for the others without.
  template <typename Stream>
  awaitable<Message> Read(Stream& stream, beast::flat_buffer& buffer,
                          std::chrono::seconds patience) {
    beast::tcp_stream& connection = beast::get_lowest_layer(stream);
    const WaitingConnections::Place place(waiting_, connection);
    if (buffer.size() == 0) {
      connection.expires_after(patience);
      const auto space = buffer.prepare(kMaxHeader);
      buffer.commit(co_await stream.async_read_some(space, use_awaitable));
    }
    http::request_parser<http::string_body> parser;
    parser.header_limit(kMaxHeader);
    parser.body_limit(kMaxBody);
    connection.expires_after(kHeaderTime);
    co_await http::async_read_header(stream, buffer, parser, use_awaitable);
    connection.expires_after(kBodyTime);
    co_await http::async_read(stream, buffer, parser, use_awaitable);
    co_return parser.release();
  }

  awaitable<HttpResponse> Answer(const HttpRequest& request) {
    if (!handler_.is_slow(request)) co_return handler_.answer(request);
    const auto answer = [this, &request]() -> awaitable<HttpResponse> {
      co_return handler_.answer(request);
    };
    co_return co_await asio::co_spawn(slow_, answer, use_awaitable);
  }

  const HttpOptions options_;
  const Handler handler_;
  int num_connections_ = 0;
  WaitingConnections waiting_;  // outlives the coroutines, which end with the context
  asio::io_context context_{1};
  asio::thread_pool slow_{8};
  asio::signal_set hang_up_{context_, SIGHUP}, without_use_{context_, SIGUSR1, SIGUSR2};
  std::optional<asio::ssl::context> tls_;
  tcp::acceptor acceptor_{context_};
};

HttpServer::HttpServer(const HttpOptions& options, Handler handler)
    : impl_(std::make_unique<Impl>(options, std::move(handler))) {}
HttpServer::~HttpServer() = default;
std::string HttpServer::Address() const { return impl_->Address(); }
void HttpServer::Run() { impl_->Run(); }

}  // namespace fovea::observer
