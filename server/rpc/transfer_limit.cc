#include "server/rpc/transfer_limit.h"

#include "server/rpc/event_loop.h"

namespace fovea::server {

void TransferLimit::Begin(const std::shared_ptr<void>& call) {
  // A new one for each, since one that was cancelled may not be set again before it has said so.
  alarm_ = std::make_unique<grpc::Alarm>();
  alarm_->Set(queue_, std::chrono::system_clock::now() + limit_, Then([this, call](bool passed) {
                if (!passed) return;
                passed_ = true;
                context_->TryCancel();
              }));
}

void TransferLimit::BeginAnswer(const std::shared_ptr<void>& call, std::size_t bytes) {
  answer_ = unsent_.Add(bytes, [this, weak = std::weak_ptr(call)] {
    if (const auto alive = weak.lock()) context_->TryCancel();
  });
  Begin(call);
}

}  // namespace fovea::server
