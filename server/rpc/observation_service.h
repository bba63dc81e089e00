#pragma once

#include <chrono>

#include "fovea/v1/observation_service.grpc.pb.h"
#include "server/access/observer_gate.h"
#include "server/connections/call_account.h"
#include "server/connections/connection_table.h"
#include "server/frame_answerer.h"
#include "server/observing/pick_board.h"
#include "server/observing/trial_bench.h"
#include "server/observing/watch_hub.h"
#include "server/rpc/late_reading.h"
#include "server/rpc/live_calls.h"
#include "server/rpc/unsent_answers.h"

namespace fovea::server {

struct ObservationEnvironment;

// Watch comes as raw bytes: one message goes to many, and one that is no request gets an answer.
// It is WatchCall's; the others hold a thread of gRPC each, and their limits let few do so.
class ObservationService final
    : public v1::ObservationService::WithRawMethod_Watch<v1::ObservationService::Service> {
 public:
  ObservationService();

  // Before the first call comes; must outlive the last.
  void Use(const ObservationEnvironment& environment) { environment_ = &environment; }

 private:
  template <typename Response>
  using Method = grpc::Status (ObservationService::*)(grpc::ServerContext*, LateStream<Response>*,
                                                      Response*);
  template <typename Response>
  void Answer(int place, Method<Response> method);

  TransferRules Rules() const;
  // Throws PermissionDenied where the observer has not that right.
  ObserverEntry Admit(const grpc::ServerContext& context, CallAccount* account,
                      bool ObserverRights::*right, const char* name) const;
  template <typename Request, typename Response>
  grpc::Status ReadFrom(grpc::ServerContext* context, LateStream<Response>* stream,
                        CallAccount* account, Request* request) const;

  grpc::Status TryOptions(grpc::ServerContext* context, LateStream<v1::TryResponse>* stream,
                          v1::TryResponse* response);
  grpc::Status TellOptions(grpc::ServerContext* context,
                           LateStream<v1::ListOptionsResponse>* stream,
                           v1::ListOptionsResponse* response);
  grpc::Status PassSelection(grpc::ServerContext* context,
                             LateStream<v1::SelectObjectResponse>* stream,
                             v1::SelectObjectResponse* response);

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
  UnsentAnswers& unsent;
};

}  // namespace fovea::server
