// What is kept of robots that are looked at closely.
#include "client/observer/board.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "client/observer/board_json.h"
#include "client/observer/feed.h"

namespace fovea::testing {
namespace {

using observer::Board;
using observer::Feed;
using observer::Look;

v1::Observer WhoSeesAll() {
  v1::Observer who;
  who.add_rights(v1::OBSERVER_RIGHT_VIEW);
  who.add_robots("*");
  return who;
}

v1::WatchResponse FrameOfArm(std::uint64_t sequence, std::size_t bytes = 0) {
  v1::WatchResponse response;
  response.mutable_frame()->set_picture(std::string(bytes, 'x'));
  response.mutable_frame()->set_robot("arm");
  response.mutable_frame()->set_sequence(sequence);
  return response;
}

// The number of the frame that is told to who looks so; 0 where none is.
std::uint64_t CloseId(const Board& board, Look look = Look::kClose) {
  std::uint64_t version = 0;
  const auto changes = nlohmann::json::parse(board.ChangesSince(&version, "arm", look));
  return changes.contains("close") ? changes["close"]["id"].get<std::uint64_t>() : 0;
}

TEST(ObserverBoard, ALookThatStartsShowsNothingOfTheOneBefore) {
  Feed feed(observer::LinkServers("127.0.0.1:1", {}), "token");  // where nobody is
  feed.board().OnObserver(0, WhoSeesAll());
  Feed::CloseLook first = feed.LookAt("arm", /*with_depth=*/false);
  feed.board().OnFrame(0, FrameOfArm(1), Look::kClose);
  EXPECT_NE(CloseId(feed.board()), 0U);
  Feed::CloseLook second = feed.LookAt("arm", /*with_depth=*/false);
  EXPECT_NE(CloseId(feed.board()), 0U) << "somebody looks at it still";
  first.reset();
  second.reset();
  EXPECT_EQ(CloseId(feed.board()), 0U) << "nobody looks at it";
  feed.board().OnFrame(0, FrameOfArm(2), Look::kClose);  // which was on its way
  const Feed::CloseLook later = feed.LookAt("arm", /*with_depth=*/false);
  EXPECT_EQ(CloseId(feed.board()), 0U) << "it may be hours old";
}

TEST(ObserverBoard, LooksWithDepthAndWithoutAreToldTheirOwnFrames) {
  Board board({"server"});
  board.OnObserver(0, WhoSeesAll());
  board.OnFrame(0, FrameOfArm(1), Look::kCloseWithDepth);
  const std::uint64_t with_depth = CloseId(board, Look::kCloseWithDepth);
  EXPECT_NE(with_depth, 0U);
  EXPECT_EQ(CloseId(board, Look::kClose), 0U);
  board.OnFrame(0, FrameOfArm(1), Look::kClose);
  EXPECT_EQ(CloseId(board, Look::kCloseWithDepth), with_depth) << "the same frame again, without";
  EXPECT_NE(CloseId(board, Look::kClose), 0U);
  EXPECT_TRUE(board.Frame("arm", with_depth));
  EXPECT_TRUE(board.Frame("arm", CloseId(board, Look::kClose)));
}

TEST(ObserverBoard, KeepsForSlowConnectionsWhatTheyWereTold) {
  Board board({"server"});
  board.OnObserver(0, WhoSeesAll());
  board.OnFrame(0, FrameOfArm(1), Look::kClose);
  const std::uint64_t told = CloseId(board);
  for (std::uint64_t i = 2; i < 20; ++i) board.OnFrame(0, FrameOfArm(i), Look::kClose);
  EXPECT_TRUE(board.Frame("arm", told));
}

TEST(ObserverBoard, HasANameForEveryRight) {
  const auto* const rights = v1::ObserverRight_descriptor();
  for (int i = 1; i < rights->value_count(); ++i) {
    v1::Observer who;
    who.add_rights(static_cast<v1::ObserverRight>(rights->value(i)->number()));
    const std::string name = observer::ObserverJson(who)["rights"][0];
    std::string full = "OBSERVER_RIGHT_" + name;
    std::ranges::transform(full, full.begin(), [](unsigned char c) { return std::toupper(c); });
    EXPECT_EQ(full, rights->value(i)->name());
  }
}

TEST(ObserverBoard, KeepsFewLargeFrames) {
  constexpr std::size_t kLargeFrame = std::size_t{6} << 20;
  Board board({"server"});
  board.OnObserver(0, WhoSeesAll());
  std::vector<std::uint64_t> told;
  for (std::uint64_t i = 1; i < 10; ++i) {
    board.OnFrame(0, FrameOfArm(i, kLargeFrame), Look::kClose);
    told.push_back(CloseId(board));
  }
  const auto is_there = [&](std::uint64_t id) { return board.Frame("arm", id) != nullptr; };
  EXPECT_EQ(std::ranges::count_if(told, is_there), 4);
  EXPECT_TRUE(is_there(told.back()));
}

}  // namespace
}  // namespace fovea::testing
