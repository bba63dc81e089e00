#pragma once

#include <chrono>

#include "fovea/v1/observation_service.grpc.pb.h"
#include "server/access/observer_gate.h"
#include "server/connections/connection_table.h"
#include "server/frame_answerer.h"
#include "server/observing/pick_board.h"
#include "server/observing/trial_bench.h"
#include "server/observing/watch_hub.h"
#include "server/rpc/live_calls.h"

namespace fovea::server {

struct ObservationEnvironment;

// Watch comes as raw bytes: one message goes to many, and one that is no request gets an answer.
// It is WatchCall's; the others hold a thread of gRPC each, and their limits let few do so.
class ObservationService final
    : public v1::ObservationService::WithRawMethod_Watch<v1::ObservationService::Service> {
 public:
  // Before the first call comes; must outlive the last.
  void Use(const ObservationEnvironment& environment) { environment_ = &environment; }

  grpc::Status Try(grpc::ServerContext* context, const v1::TryRequest* request,
                   v1::TryResponse* response) override;
  grpc::Status ListOptions(grpc::ServerContext* context, const v1::ListOptionsRequest* request,
                           v1::ListOptionsResponse* response) override;
  grpc::Status SelectObject(grpc::ServerContext* context, const v1::SelectObjectRequest* request,
                            v1::SelectObjectResponse* response) override;

 private:
  const ObservationEnvironment* environment_ = nullptr;
};

// What calls of observers work with; outlives all of them.
struct ObservationEnvironment {
  ObservationService& service;
  grpc::ServerCompletionQueue* queue;
  LiveCalls& live_calls;
  const ObserverGate& gate;
  WatchHub& hub;
  const FrameAnswerer& answerer;
  TrialBench& trials;
  PickBoard& picks;
  const v1::ListOptionsResponse& options;
  ConnectionTable& connections;
  std::chrono::seconds max_transfer;
};

}  // namespace fovea::server
