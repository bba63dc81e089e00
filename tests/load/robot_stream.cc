#include "tests/load/robot_stream.h"

#include <chrono>
#include <utility>

namespace fovea::load {
namespace {

constexpr std::chrono::hours kForEver{24};

}  // namespace

RobotStream::RobotStream(const client::Client& client, bool resuming)
    : plain_(resuming ? nullptr : client.OpenStream(kForEver)),
      resuming_(resuming ? client.OpenResumingStream(kForEver) : nullptr) {}

bool RobotStream::Send(const v1::DetectStreamRequest& request) {
  if (plain_) return plain_->Send(request);
  resuming_->Send(request);
  return true;
}

void RobotStream::DoneSending() {
  if (plain_) {
    plain_->DoneSending();
  } else {
    resuming_->DoneSending();
  }
}

std::optional<client::ResumingStream::Answer> RobotStream::Receive() {
  if (resuming_) return resuming_->Receive();
  auto response = plain_->Receive();
  if (!response) return std::nullopt;
  return client::ResumingStream::Answer{.response = std::move(*response)};
}

}  // namespace fovea::load
