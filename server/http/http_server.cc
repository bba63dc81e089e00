#include "server/http/http_server.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <chrono>
#include <exception>
#include <list>
#include <memory>
#include <stdexcept>
#include <thread>
#include <utility>

#include "server/server_options.h"

namespace fovea::server {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using asio::ip::tcp;
using boost::system::error_code;

constexpr std::chrono::seconds kToAsk{2}, kToRead{10};
constexpr std::size_t kMaxRequestBytes = 8 << 10;
// Without descriptors accepting fails at once, again and again.
constexpr std::chrono::milliseconds kAfterFailure{100};

// Few where few files may be open: who looks at metrics does not take those of callers.
std::size_t MaxConnections() {
  constexpr long kFewest = 4, kMost = 64, kShare = 8;
  const long files = sysconf(_SC_OPEN_MAX);  // below 0: any number
  return static_cast<std::size_t>(files < 0 ? kMost : std::clamp(files / kShare, kFewest, kMost));
}

using Response = http::response<http::string_body>;

Response ResponseOf(HttpAnswer answer) {
  Response response(http::int_to_status(static_cast<unsigned>(answer.status)), 11);
  response.set(http::field::content_type, answer.content_type);
  response.keep_alive(false);
  response.body() = std::move(answer.body);
  response.prepare_payload();
  return response;
}

Response Answer(const http::request<http::empty_body>& request,
                const HttpServer::Handler& handler) {
  if (request.method() != http::verb::get) {
    Response refusal = ResponseOf({.status = 405, .body = "only GET is answered\n"});
    refusal.set(http::field::allow, "GET");
    return refusal;
  }
  try {
    const std::string target(request.target());
    return ResponseOf(handler(std::string_view(target).substr(0, target.find('?'))));
  } catch (const std::exception& error) {
    spdlog::error("internal error at --metrics-listen: {}", error.what());
    return ResponseOf({.status = 500, .body = "internal error; the server's log says more\n"});
  }
}

}  // namespace

// Lives as long as an operation refers to it; each has a deadline, which closes the connection.
class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(tcp::socket socket, const HttpServer::Handler& handler)
      : stream_(std::move(socket)), handler_(handler) {
    parser_.header_limit(kMaxRequestBytes);
  }

  void Serve() {
    stream_.expires_after(kToAsk);
    // Only the header: a body has no meaning here.
    http::async_read_header(stream_, buffer_, parser_,
                            [self = shared_from_this()](error_code error, std::size_t) {
                              if (!error) self->Write();
                            });
  }

  void Close() { stream_.close(); }

 private:
  void Write() {
    response_ = Answer(parser_.get(), handler_);
    stream_.expires_after(kToRead);
    http::async_write(stream_, response_, [self = shared_from_this()](error_code, std::size_t) {
      error_code ignored;  // the caller may be gone
      self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    });
  }

  beast::tcp_stream stream_;
  const HttpServer::Handler& handler_;
  beast::flat_static_buffer<kMaxRequestBytes> buffer_;
  http::request_parser<http::empty_body> parser_;
  Response response_;
};

class HttpServer::Impl {
 public:
  Impl(const char* flag, const std::string& listen, Handler handler)
      : host_(HostOf(listen)), handler_(std::move(handler)) {
    try {
      Listen(listen);
    } catch (const boost::system::system_error& error) {
      throw std::runtime_error(std::string(flag) + ": cannot listen on " + listen + ": " +
                               error.code().message());
    }
    Accept();
    thread_ = std::jthread([this] { Run(); });
  }

  ~Impl() { context_.stop(); }

  std::string Address() const {
    return host_ + ":" + std::to_string(acceptor_.local_endpoint().port());
  }

 private:
  void Listen(const std::string& listen) {
    const bool in_brackets = host_.starts_with('[') && host_.ends_with(']');  // [::1]
    const std::string host = in_brackets ? host_.substr(1, host_.size() - 2) : host_;
    const tcp::endpoint endpoint = tcp::resolver(context_)
                                       .resolve(host, listen.substr(listen.rfind(':') + 1))
                                       .begin()
                                       ->endpoint();
    acceptor_.open(endpoint.protocol());
    acceptor_.set_option(tcp::acceptor::reuse_address(true));
    acceptor_.bind(endpoint);
    acceptor_.listen();
  }

  // What is thrown on the way, for want of memory, costs the connection that it was for.
  void Run() {
    while (!context_.stopped()) {
      try {
        context_.run();
      } catch (const std::exception& error) {
        spdlog::error("internal error at --metrics-listen: {}", error.what());
      }
    }
  }

  void Accept() {
    acceptor_.async_accept([this](error_code error, tcp::socket socket) {
      if (error) {
        pause_.expires_after(kAfterFailure);
        pause_.async_wait([this](error_code) { Accept(); });
        return;
      }
      Accept();
      Begin(std::move(socket));
    });
  }

  void Begin(tcp::socket socket) {
    connections_.remove_if([](const auto& connection) { return connection.expired(); });
    if (connections_.size() >= max_connections_) {
      if (const auto oldest = connections_.front().lock()) oldest->Close();
      connections_.pop_front();
    }
    const auto connection = std::make_shared<HttpConnection>(std::move(socket), handler_);
    connections_.push_back(connection);
    connection->Serve();
  }

  const std::string host_;
  const Handler handler_;
  const std::size_t max_connections_ = MaxConnections();
  asio::io_context context_{1};
  tcp::acceptor acceptor_{context_};
  asio::steady_timer pause_{context_};
  std::list<std::weak_ptr<HttpConnection>> connections_;  // oldest first
  std::jthread thread_;
};

HttpServer::HttpServer(const char* flag, const std::string& listen, Handler handler)
    : impl_(std::make_unique<Impl>(flag, listen, std::move(handler))) {}

HttpServer::~HttpServer() = default;

std::string HttpServer::Address() const { return impl_->Address(); }

}  // namespace fovea::server
