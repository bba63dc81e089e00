// What is posted, as the other side sees it.
#include "server/http/http_post.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/write.hpp>
#include <stdexcept>
#include <string>
#include <thread>

namespace fovea::testing {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

struct Exchange {
  std::string port;
  std::string header;  // of the request
  server::PostResult result;
};

// Posts to a server that answers with these bytes.
Exchange Post(const std::string& path, const std::string& answer) {
  asio::io_context context;
  tcp::acceptor acceptor(context, {asio::ip::address_v4::loopback(), 0});
  Exchange exchange{
      .port = std::to_string(acceptor.local_endpoint().port()), .header = "", .result = {}};
  const std::jthread thread([&] {
    tcp::socket socket = acceptor.accept();
    boost::system::error_code error;
    asio::read_until(socket, asio::dynamic_buffer(exchange.header), "{}", error);
    asio::write(socket, asio::buffer(answer), error);
  });
  const auto url = server::ParseHttpUrl("--flag", "http://127.0.0.1:" + exchange.port + path);
  exchange.result = server::PostJson(url, "{}", std::chrono::minutes(1), [] { return false; });
  return exchange;
}

TEST(HttpPost, NamesHostPortAndPath) {
  const Exchange exchange =
      Post("/v1/traces?tenant=7", "HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\nok");
  EXPECT_EQ(exchange.result.problem, "");
  EXPECT_EQ(exchange.result.body, "ok");
  EXPECT_THAT(exchange.header, StartsWith("POST /v1/traces?tenant=7 HTTP/1.1\r\n"));
  EXPECT_THAT(exchange.header, HasSubstr("\r\nHost: 127.0.0.1:" + exchange.port + "\r\n"));
}

TEST(HttpPost, GoesOnToTheAnswerBehindOthers) {
  const std::string before =
      "HTTP/1.1 100 Continue\r\n\r\nHTTP/1.1 103 Early Hints\r\nLink: x\r\n\r\n";
  const Exchange taken = Post("", before + "HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\nok");
  EXPECT_EQ(taken.result.problem, "");
  EXPECT_EQ(taken.result.body, "ok");
  const Exchange refused = Post("", before + "HTTP/1.1 503 No\r\nContent-Length: 0\r\n\r\n");
  EXPECT_EQ(refused.result.problem, "HTTP status 503");
  EXPECT_EQ(Post("", "HTTP/1.1 101 Other\r\n\r\n").result.problem, "HTTP status 101");
  EXPECT_NE(Post("", before).result.problem, "");
}

TEST(HttpUrl, HasHostPortAndPath) {
  const auto parts = [](const char* text) {
    const server::HttpUrl url = server::ParseHttpUrl("--flag", text);
    return url.host + " " + url.port + " " + url.path;
  };
  EXPECT_EQ(parts("http://collector:4318/v1/traces"), "collector 4318 /v1/traces");
  EXPECT_EQ(parts("http://10.0.0.1"), "10.0.0.1 80 /");
  EXPECT_EQ(parts("http://[::1]:4318"), "::1 4318 /");
  EXPECT_EQ(parts("http://h?x"), "h 80 /?x");
  EXPECT_EQ(parts("http://h:1?x/y"), "h 1 /?x/y");
  EXPECT_EQ(parts("http://h/a?b@c"), "h 80 /a?b@c");
  for (const char* bad : {"collector:4318", "https://collector", "http://", "http://:80/",
                          "http://a:/", "http://a:99999", "http://a:b", "http://a b/", "http://[]",
                          "http://[::1", "http://[::1]x", "http://a#b"}) {
    EXPECT_THAT([&] { server::ParseHttpUrl("--flag", bad); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("--flag: \"" + std::string(bad))))
        << bad;
  }
}

TEST(HttpUrl, IsNamedWithoutItsSecrets) {
  EXPECT_EQ(server::WithoutSecrets("http://h:1/a/b"), "http://h:1/a/b");
  EXPECT_EQ(server::WithoutSecrets("http://h/a?key=b@c/d?e"), "http://h/a?...");
  EXPECT_EQ(server::WithoutSecrets("http://me:secret@h/a@b"), "http://...@h/a@b");
  EXPECT_EQ(server::WithoutSecrets("me:secret@h"), "...@h");
  const std::vector<std::pair<std::string, std::string>> cases{{"http://?x", "http://?..."},
                                                               {"http://me@a", "http://...@a"}};
  for (const auto& [bad, shown] : cases) {
    EXPECT_THAT(
        [&] { server::ParseHttpUrl("--flag", bad); },
        ThrowsMessage<std::invalid_argument>(StartsWith("--flag: \"" + shown + "\" is not")));
  }
}

TEST(HttpUrl, HasAnAuthorityForTheHeader) {
  const auto authority = [](const char* text) {
    return server::ParseHttpUrl("--flag", text).Authority();
  };
  EXPECT_EQ(authority("http://collector:4318/v1/traces"), "collector:4318");
  EXPECT_EQ(authority("http://[::1]:4330"), "[::1]:4330");
  EXPECT_EQ(authority("http://[::1]/"), "[::1]");
  EXPECT_EQ(authority("http://collector:80"), "collector");
}

}  // namespace
}  // namespace fovea::testing
