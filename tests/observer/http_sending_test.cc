#include "client/observer/http_sending.h"

#include <gtest/gtest.h>

#include <boost/system/error_code.hpp>
#include <exception>
#include <string>
#include <vector>

namespace fovea::testing {

namespace asio = boost::asio;

// Not in the unnamed namespace, as coroutines have fields of it. Takes a few bytes at a time, as a
// slow connection does, and says how many of them came in each span of time that it was given.
class SlowStream {
 public:
  using executor_type = asio::any_io_executor;

  explicit SlowStream(asio::io_context& context) : context_(context) {}

  executor_type get_executor() { return context_.get_executor(); }
  void close() {}
  void expires_after(std::chrono::nanoseconds time) {
    EXPECT_EQ(time, observer::kWriteTime);
    bytes_of_spans.push_back(0);
  }

  template <typename Buffers, typename Token>
  auto async_write_some(const Buffers& buffers, Token&& token) {
    return asio::async_initiate<Token, void(boost::system::error_code, std::size_t)>(
        [this](auto handler, const Buffers& offered) {
          std::string taken(10'000, '\0');
          taken.resize(asio::buffer_copy(asio::buffer(taken), offered));
          received += taken;
          bytes_of_spans.back() += taken.size();
          asio::post(context_, [handler = std::move(handler), size = taken.size()]() mutable {
            handler(boost::system::error_code(), size);
          });
        },
        token, buffers);
  }

  std::string received;
  std::vector<std::size_t> bytes_of_spans;

 private:
  asio::io_context& context_;
};

namespace {

std::string Letters(std::size_t size) {
  std::string text(size, ' ');
  for (std::size_t i = 0; i < size; ++i) text[i] = static_cast<char>('a' + i % 23);
  return text;
}

// What arrives, piece by piece, is both texts; the sizes of the pieces.
std::vector<std::size_t> SizesOfPieces(const std::string& first, const std::string& rest) {
  asio::io_context context;
  SlowStream stream(context);
  observer::WaitingConnections waiting;
  asio::co_spawn(context, observer::Send(stream, waiting, first, rest),
                 [](const std::exception_ptr& error) { EXPECT_FALSE(error); });
  context.run();
  EXPECT_EQ(stream.received, first + rest);
  return stream.bytes_of_spans;
}

TEST(ObserverSend, GivesEachPieceTimeOfItsOwn) {
  constexpr std::size_t kPiece = observer::kPieceBytes;
  const std::vector<std::size_t> sizes = SizesOfPieces(Letters(300), Letters(3 * kPiece));
  EXPECT_EQ(sizes, (std::vector<std::size_t>{kPiece, kPiece, kPiece, 300}));
  EXPECT_EQ(SizesOfPieces(Letters(2 * kPiece + 1), Letters(kPiece - 1)).size(), 3U);
}

TEST(ObserverSend, SendsWhatIsShortAtOnce) {
  EXPECT_EQ(SizesOfPieces("head", "body"), std::vector<std::size_t>{8});
  EXPECT_EQ(SizesOfPieces("head", ""), std::vector<std::size_t>{4});
  EXPECT_TRUE(SizesOfPieces("", "").empty());
}

}  // namespace
}  // namespace fovea::testing
