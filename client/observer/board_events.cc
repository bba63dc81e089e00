#include "client/observer/board_events.h"

#include <utility>

namespace fovea::observer {

BoardEvents::BoardEvents(std::shared_ptr<Feed> feed, std::string close, bool with_depth)
    : feed_(std::move(feed)),
      close_(std::move(close)),
      look_(close_.empty() ? nullptr : feed_->LookAt(close_, with_depth)) {}

BoardEvents::~BoardEvents() { subscription_.reset(); }

std::string BoardEvents::Take() {
  if (told_end_) return {};
  if (feed_->board().IsRefused()) {
    told_end_ = true;
    return "event: ended\ndata: {}\n\n";
  }
  const std::string changes = feed_->board().ChangesSince(&version_, close_);
  return changes.empty() ? "" : "data: " + changes + "\n\n";
}

void BoardEvents::OnNews(std::function<void()> wake) {
  subscription_ = feed_->board().Subscribe(std::move(wake));
}

}  // namespace fovea::observer
