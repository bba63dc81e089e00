// A robot's stream: one that breaks for good, or one that is opened again.
#pragma once

#include <memory>
#include <optional>

#include "client/client.h"

namespace fovea::load {

class RobotStream {
 public:
  RobotStream(const client::Client& client, bool resuming);

  // False where the stream has broken for good.
  bool Send(const v1::DetectStreamRequest& request);
  void DoneSending();
  // Empty at the end; throws RpcError where it breaks for good.
  std::optional<client::ResumingStream::Answer> Receive();

 private:
  std::unique_ptr<client::DetectStream> plain_;
  std::unique_ptr<client::ResumingStream> resuming_;
};

}  // namespace fovea::load
