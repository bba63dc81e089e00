#include "server/rpc/transfer_limit.h"

#include <utility>

#include "server/rpc/event_loop.h"
#include "server/status.h"

namespace fovea::server {

void TransferLimit::Begin(const std::shared_ptr<void>& call, std::function<void()> on_late) {
  const std::uint64_t transfer = NextTransfer();
  if (!on_late) return SetAlarm(call, [=, this] { Cancel(transfer, StatusOfSlowness()); });
  SetAlarm(call, [=, this, on_late = std::move(on_late)] {
    if (EndLate(transfer)) on_late();
  });
}

void TransferLimit::BeginAnswer(const std::shared_ptr<void>& call, std::size_t bytes) {
  const std::uint64_t transfer = NextTransfer();
  answer_ = unsent_.Add(bytes, [this, transfer, weak = std::weak_ptr(call)] {
    if (const auto alive = weak.lock()) Cancel(transfer, StatusOfUnsentAnswer());
  });
  SetAlarm(call, [=, this] { Cancel(transfer, StatusOfUntakenAnswer()); });
}

std::uint64_t TransferLimit::NextTransfer() {
  const std::lock_guard lock(mutex_);
  running_ = true;
  return ++transfer_;
}

void TransferLimit::SetAlarm(const std::shared_ptr<void>& call, std::function<void()> on_late) {
  // A new one for each, since one that was cancelled may not be set again before it has said so.
  alarm_ = std::make_unique<grpc::Alarm>();
  alarm_->Set(queue_, std::chrono::system_clock::now() + limit_,
              Then([call, on_late = std::move(on_late)](bool passed) {
                if (passed) on_late();
              }));
}

bool TransferLimit::EndLate(std::uint64_t transfer) {
  const std::lock_guard lock(mutex_);
  if (!running_ || transfer != transfer_) return false;
  running_ = false;
  return true;
}

void TransferLimit::Cancel(std::uint64_t transfer, const grpc::Status& why) {
  const std::lock_guard lock(mutex_);
  if (!running_ || transfer != transfer_) return;
  if (!why_cancelled_) why_cancelled_ = why;
  context_->TryCancel();
}

void TransferLimit::End() {
  {
    const std::lock_guard lock(mutex_);
    running_ = false;
  }
  alarm_.reset();
  answer_.reset();
}

}  // namespace fovea::server
