// Alarms that come late: whoever empties the queue is busy.
#include "server/rpc/transfer_limit.h"

#include <gtest/gtest.h>

#include <memory>

#include "server/rpc/event_loop.h"

namespace fovea::testing {
namespace {

using server::CallEvent;
using server::TransferLimit;
using server::UnsentAnswers;

// TryCancel() of a context that has no call, as here, does not come back.
class TransferLimitTest : public ::testing::Test {
 protected:
  TransferLimitTest()
      : context_(std::make_unique<grpc::ServerContext>()),
        limit_(std::make_shared<TransferLimit>(context_.get(), &queue_, std::chrono::seconds(0),
                                               unsent_)) {}
  ~TransferLimitTest() override {
    limit_.reset();
    queue_.Shutdown();
    while (AlarmComes()) {
    }
  }

  // The next one, whether it has rung or was cancelled; false where there is none.
  bool AlarmComes() {
    void* tag = nullptr;
    bool rang = false;
    if (!queue_.Next(&tag, &rang)) return false;
    const std::unique_ptr<CallEvent> event(static_cast<CallEvent*>(tag));
    event->then(rang);
    rang_ = rang_ || rang;
    return true;
  }

  grpc::CompletionQueue queue_;
  UnsentAnswers unsent_{100};
  std::unique_ptr<grpc::ServerContext> context_;
  std::shared_ptr<TransferLimit> limit_;
  bool rang_ = false;
};

TEST_F(TransferLimitTest, AnAlarmThatComesAfterTheEndLeavesTheCallAlone) {
  while (!rang_) {  // else it was cancelled before it rang
    limit_->Begin(limit_);
    limit_->End();
    context_.reset();
    AlarmComes();
  }
  EXPECT_FALSE(limit_->why_cancelled());
}

TEST_F(TransferLimitTest, AnAnswerThatIsSentIsNotCancelledForOthers) {
  limit_->BeginAnswer(limit_, 60);
  limit_->End();
  context_.reset();
  const auto other = unsent_.Add(60, [] {});
  EXPECT_TRUE(AlarmComes());
  EXPECT_FALSE(limit_->why_cancelled());
}

}  // namespace
}  // namespace fovea::testing
