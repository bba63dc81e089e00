#pragma once

#include <array>
#include <boost/asio.hpp>
#include <boost/beast/core.hpp>
#include <chrono>
#include <cstddef>
#include <string_view>
#include <utility>  // Boost.Asio 1.74 forgets it

#include "client/observer/waiting_connections.h"

namespace fovea::observer {

// Who takes a piece in that time gets all, however much it is.
constexpr std::chrono::seconds kWriteTime{20};
constexpr std::size_t kPieceBytes = 64 << 10;

// One after the other, in pieces that each have time of their own, and of which each is waited for
// anew. Both texts stay where they are.
template <typename Stream>
boost::asio::awaitable<void> Send(Stream& stream, WaitingConnections& waiting,
                                  std::string_view first, std::string_view rest = {}) {
  namespace asio = boost::asio;
  while (!first.empty() || !rest.empty()) {
    const std::string_view begin = first.substr(0, kPieceBytes);
    const std::string_view then = rest.substr(0, kPieceBytes - begin.size());
    const std::array<asio::const_buffer, 2> piece = {asio::buffer(begin), asio::buffer(then)};
    auto& connection = boost::beast::get_lowest_layer(stream);
    const WaitingConnections::Place place(waiting, connection);
    connection.expires_after(kWriteTime);
    co_await asio::async_write(stream, piece, asio::use_awaitable);
    first.remove_prefix(begin.size());
    rest.remove_prefix(then.size());
  }
}

}  // namespace fovea::observer
