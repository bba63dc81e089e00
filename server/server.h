#pragma once

#include <grpcpp/server.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/access/access_watch.h"
#include "server/access/credentials.h"
#include "server/access/gate_keeper.h"
#include "server/access/observer_gate.h"
#include "server/access/stream_places.h"
#include "server/connections/connection_table.h"
#include "server/connections/door.h"
#include "server/frame_answerer.h"
#include "server/observing/pick_board.h"
#include "server/observing/trial_bench.h"
#include "server/observing/watch_hub.h"
#include "server/rpc/detection_service.h"
#include "server/rpc/event_loop.h"
#include "server/rpc/live_calls.h"
#include "server/rpc/observation_service.h"
#include "server/scheduling/scheduler.h"
#include "server/server_options.h"
#include "server/tracing/tracer.h"
#include "server/watching/metrics.h"

namespace fovea::server {

// A running gRPC server: fovea.v1.DetectionService, ObservationService, grpc.health.v1.Health and
// reflection.
class Server {
 public:
  // Listens and serves when this returns. Throws std::invalid_argument for options that do not
  // validate, std::runtime_error where the address cannot be listened on.
  explicit Server(const ServerOptions& options, DetectFunction detect = fovea::Detect);

  // Like Drain() without patience.
  ~Server();

  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  // Takes over the tokens, observers and certificates that the files hold now, and ends the streams
  // of those who may not call any more. Throws std::exception, and changes nothing then.
  void ReloadAccess();

  // When its certificate expires; none without TLS.
  std::optional<std::chrono::sys_seconds> CertificateExpiry() const {
    return credentials_.Expiry();
  }

  // Whether callers need a token and the file holds none.
  bool RefusesEverybody() const { return gate_keeper_.RefusesEverybody(); }

  // For Prometheus to collect.
  const std::shared_ptr<Metrics>& metrics() const { return metrics_; }

  // Whether calls are welcome: until StopAdvertising() or Drain().
  bool IsServing() const { return serving_; }

  // What it listens on, with the real port where 0 was asked for; the first of them.
  std::vector<std::string> Addresses() const;
  std::string Address() const { return Addresses().front(); }

  // Where it can be checked from outside.
  Door& door() { return door_; }
  const ConnectionTable& connections() const { return connections_; }

  // Reports NOT_SERVING to whoever checks its health, and serves on: load balancers and clients
  // have time to turn elsewhere before Drain().
  void StopAdvertising();

  // Refuses new calls with UNAVAILABLE, ends streams after the answer they are at, lets calls under
  // way finish until the drain timeout and cancels what is left. Returns when all are gone, and how
  // many were cancelled.
  std::size_t Drain() { return Stop(options_.drain_timeout_s); }

 private:
  void Listen();
  void Serve();
  std::size_t Stop(int timeout_s);
  void AddGauges();
  void AddTraceCounters();
  void AddWatchCounters();
  void AcceptObservers();

  const ServerOptions options_;
  const SchedulerLimits limits_;
  Scheduler scheduler_;
  const std::shared_ptr<Metrics> metrics_;
  const std::unique_ptr<Tracer> tracer_;  // null where no traces are wanted
  ObserverGate observer_gate_;
  // Null where there are no observers.
  const std::unique_ptr<WatchHub> watch_hub_;
  const std::unique_ptr<TrialBench> trial_bench_;
  const std::unique_ptr<PickBoard> pick_board_;
  const FrameAnswerer answerer_;
  Credentials credentials_;
  GateKeeper gate_keeper_;
  StreamPlaces stream_places_;
  UnsentAnswers unsent_answers_;
  FrameRoom frame_room_;
  LiveCalls live_calls_;
  ConnectionTable connections_;
  DetectionService service_;
  ObservationService observation_service_;
  Door door_;
  std::unique_ptr<Door::Acceptor> callers_, self_;  // until the door opens
  std::atomic<bool> serving_ = false;
  std::unique_ptr<grpc::Server> server_;
  std::unique_ptr<EventLoop> loop_;
  std::unique_ptr<CallEnvironment> environment_;
  std::unique_ptr<ObservationEnvironment> observation_environment_;
  std::unique_ptr<AccessWatch> access_watch_;
};

}  // namespace fovea::server
