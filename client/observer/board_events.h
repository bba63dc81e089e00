#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "client/observer/feed.h"
#include "client/observer/http_types.h"
#include "client/observer/sessions.h"

namespace fovea::observer {

// What changes on a feed's board, and of one robot that is looked at closely. A slow reader gets
// fewer events, each with all that has changed since the one before. Ends with the session.
class BoardEvents : public EventSource {
 public:
  // `close` may be empty.
  BoardEvents(const Session& session, std::string close, bool with_depth);
  ~BoardEvents() override;

  std::string Take() override;
  bool HasEnded() const override { return told_end_; }
  void OnNews(std::function<void()> wake) override;

 private:
  void LookClosely();

  const std::shared_ptr<Feed> feed_;
  const std::shared_ptr<const std::atomic<bool>> session_has_ended_;
  const std::string close_;
  const bool with_depth_;
  Feed::CloseLook look_;  // null where there has been no room for it yet
  std::uint64_t version_ = 0;
  bool told_end_ = false;
  Board::Subscription subscription_;
};

}  // namespace fovea::observer
