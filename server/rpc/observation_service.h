#pragma once

#include <chrono>

#include "fovea/v1/observation_service.grpc.pb.h"
#include "server/access/observer_gate.h"
#include "server/connections/connection_table.h"
#include "server/observing/watch_hub.h"
#include "server/rpc/live_calls.h"

namespace fovea::server {

// As raw bytes: one message goes to many, and one that is no request gets an answer.
using ObservationService =
    v1::ObservationService::WithRawMethod_Watch<v1::ObservationService::Service>;

// What calls of observers work with; outlives all of them.
struct ObservationEnvironment {
  ObservationService& service;
  grpc::ServerCompletionQueue* queue;
  LiveCalls& live_calls;
  const ObserverGate& gate;
  WatchHub& hub;
  ConnectionTable& connections;
  std::chrono::seconds max_transfer;
};

}  // namespace fovea::server
