#include "client/observer/http_server.h"

#include <gtest/gtest.h>

#include <boost/asio.hpp>
#include <csignal>
#include <future>
#include <string>

#include "tests/server/loopback.h"

namespace fovea::testing {
namespace {

namespace asio = boost::asio;

// Sends a request, whose answer nobody waits for.
asio::ip::tcp::socket AskIn(asio::io_context& context, const std::string& address) {
  const std::size_t colon = address.rfind(':');
  const auto port = static_cast<std::uint16_t>(std::stoi(address.substr(colon + 1)));
  asio::ip::tcp::socket socket(context);
  socket.connect({asio::ip::make_address(address.substr(0, colon)), port});
  asio::write(socket, asio::buffer(std::string("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n")));
  return socket;
}

TEST(ObserverHttpServer, EndsWhatIsSlowBeforeItWaitsForThat) {
  std::promise<void> asked, ended;
  observer::HttpServer server(
      {.listen = "127.0.0.1:0", .read_tls = [] { return observer::TlsFiles(); }},
      {.is_slow = [](const observer::HttpRequest&) { return true; },
       .answer =
           [&](const observer::HttpRequest&) {
             asked.set_value();
             ended.get_future().wait();
             return observer::NotFound();
           },
       .end = [&] { ended.set_value(); }});
  auto served = std::async(std::launch::async, [&] { server.Run(); });
  asio::io_context context;
  const auto socket = AskIn(context, server.Address());
  asked.get_future().wait();
  std::raise(SIGTERM);
  if (served.wait_for(kPatience) == std::future_status::ready) return;
  ADD_FAILURE() << "it waits for an answer that is not told to end";
  ended.set_value();
}

}  // namespace
}  // namespace fovea::testing
