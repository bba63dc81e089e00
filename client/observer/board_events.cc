#include "client/observer/board_events.h"

#include <utility>

namespace fovea::observer {

BoardEvents::BoardEvents(const Session& session, std::string close, bool with_depth)
    : feed_(session.feed),
      session_has_ended_(session.has_ended),
      close_(std::move(close)),
      with_depth_(with_depth) {
  LookClosely();
}

BoardEvents::~BoardEvents() { subscription_.reset(); }

void BoardEvents::LookClosely() {
  if (!close_.empty() && !look_) look_ = feed_->LookAt(close_, with_depth_);
}

std::string BoardEvents::Take() {
  if (told_end_) return {};
  if (*session_has_ended_ || feed_->board().IsRefused()) {
    told_end_ = true;
    return "event: ended\ndata: {}\n\n";
  }
  LookClosely();  // there may have been no room before
  const std::string changes = feed_->board().ChangesSince(
      &version_, close_, with_depth_ ? Look::kCloseWithDepth : Look::kClose);
  return changes.empty() ? "" : "data: " + changes + "\n\n";
}

void BoardEvents::OnNews(std::function<void()> wake) {
  subscription_ = feed_->board().Subscribe(std::move(wake));
}

}  // namespace fovea::observer
