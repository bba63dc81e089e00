#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include "fovea/v1/detection_service.grpc.pb.h"
#include "server/access/gate_keeper.h"
#include "server/access/stream_places.h"
#include "server/connections/connection_table.h"
#include "server/frame_answerer.h"
#include "server/observing/pick_board.h"
#include "server/rpc/frame_room.h"
#include "server/rpc/live_calls.h"
#include "server/rpc/transfer_limit.h"
#include "server/rpc/unsent_answers.h"
#include "server/scheduling/scheduler.h"
#include "server/watching/metrics.h"

namespace fovea::server {

// Frames are answered asynchronously, so that what waits holds no thread. Streams come as raw
// bytes: a message that cannot be parsed shall not end them.
using AsyncDetectionService =
    v1::DetectionService::WithRawMethod_DetectStream<v1::DetectionService::Service>;

// The RPCs that compute nothing; DetectCall and StreamCall are the others.
class DetectionService final : public AsyncDetectionService {
 public:
  // `info` and `options` are what GetServerInfo and ListOptions answer. The others must outlive it.
  DetectionService(v1::GetServerInfoResponse info, v1::ListOptionsResponse options,
                   const Metrics& metrics, const GateKeeper& gate_keeper,
                   ConnectionTable& connections);

  // Before the first call comes.
  void Use(const TransferRules& rules) { rules_.emplace(rules); }

  const v1::ListOptionsResponse& options() const { return options_; }

  // Completes when a call of Detect begins; its message is read thereafter, so that a call can be
  // refused before it uploads its frame.
  void RequestDetect(grpc::ServerContext* context,
                     grpc::ServerAsyncReader<v1::DetectResponse, grpc::ByteBuffer>* reader,
                     grpc::ServerCompletionQueue* queue, void* tag);

 private:
  // A method whose message says nothing, and is not even read.
  template <typename Response>
  void Answer(int method, std::function<Response()> answer);

  const v1::GetServerInfoResponse info_;
  const v1::ListOptionsResponse options_;
  const Metrics& metrics_;
  const GateKeeper& gate_keeper_;
  ConnectionTable& connections_;
  std::optional<TransferRules> rules_;
  const std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

// What a call works with; outlives all calls.
struct CallEnvironment {
  DetectionService& service;
  grpc::ServerCompletionQueue* queue;
  Scheduler& scheduler;
  const FrameAnswerer& answerer;
  LiveCalls& live_calls;
  Metrics& metrics;
  const GateKeeper& gate_keeper;
  StreamPlaces& stream_places;
  ConnectionTable& connections;
  PickBoard* picks;  // null where nobody picks
  std::chrono::seconds max_transfer;
  UnsentAnswers& unsent;
  FrameRoom& frame_room;
  // After which a stream is ended; zero = never.
  std::chrono::seconds max_stream_age;
};

}  // namespace fovea::server
