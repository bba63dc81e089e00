#include "server/server.h"

#include <google/protobuf/util/time_util.h>
#include <grpc/grpc.h>
#include <grpcpp/ext/proto_server_reflection_plugin.h>
#include <grpcpp/grpcpp.h>
#include <grpcpp/health_check_service_interface.h>
#include <grpcpp/resource_quota.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <future>
#include <stdexcept>
#include <utility>

#include "core/options.h"
#include "server/build_info.h"
#include "server/conversion/option_list.h"
#include "server/limits_of_options.h"
#include "server/rpc/detect_call.h"
#include "server/rpc/reflection_limit.h"
#include "server/rpc/stream_call.h"
#include "server/rpc/watch_call.h"

namespace fovea::server {
namespace {

const ServerOptions& Validated(const ServerOptions& options) {
  Validate(options);
  return options;
}

v1::GetServerInfoResponse InfoOf(const ServerOptions& options, const SchedulerLimits& limits) {
  v1::GetServerInfoResponse info;
  info.set_version(Version());
  info.set_build(Commit());
  *info.mutable_started_at() = google::protobuf::util::TimeUtil::GetCurrentTime();
  for (const std::string& profile : ProfileNames()) info.add_profiles(profile);
  info.set_max_message_bytes(static_cast<std::uint64_t>(options.max_message_mib) << 20);
  info.set_max_pixels(static_cast<std::uint64_t>(options.max_pixels));
  info.set_compute_threads(static_cast<std::uint32_t>(limits.num_threads));
  info.set_max_waiting(static_cast<std::uint32_t>(limits.max_waiting));
  info.set_max_per_robot(static_cast<std::uint32_t>(limits.max_per_robot));
  return info;
}

std::unique_ptr<Tracer> MakeTracer(const ServerOptions& options) {
  if (options.trace_endpoint.empty()) return nullptr;
  return std::make_unique<Tracer>(options.trace_endpoint, options.trace_share);
}

std::unique_ptr<WatchHub> MakeWatchHub(const ServerOptions& options) {
  if (options.observers.empty()) return nullptr;
  return std::make_unique<WatchHub>(static_cast<std::uint64_t>(options.max_pixels));
}

template <typename Part>
std::unique_ptr<Part> MakeIfWatched(const ServerOptions& options) {
  if (options.observers.empty()) return nullptr;
  return std::make_unique<Part>();
}

// More wait at the client until one of them is done.
constexpr int kMaxCallsPerConnection = 64;

// Of calls that ask about the server: each takes one, and more of them get RESOURCE_EXHAUSTED.
constexpr int kMaxThreads = 64;

// For refusals to reach their callers; connections where nothing is left to say close at once.
constexpr std::chrono::seconds kLastWords{1};

// Plugins of gRPC are global: they apply to every builder made afterwards.
void EnablePlugins() {
  static const bool once = [] {
    grpc::EnableDefaultHealthCheckService(true);
    grpc::reflection::InitProtoReflectionServerBuilderPlugin();
    return true;
  }();
  static_cast<void>(once);
}

void ConfigureChannel(const ServerOptions& options, grpc::ServerBuilder* builder) {
  builder->SetMaxReceiveMessageSize(options.max_message_mib << 20);
  // A message of 4 MB could be one of 4 GB that was compressed.
  builder->SetCompressionAlgorithmSupportStatus(GRPC_COMPRESS_GZIP, false);
  builder->SetCompressionAlgorithmSupportStatus(GRPC_COMPRESS_DEFLATE, false);
  // A call that is not read takes in this much and no more; one that is, its message.
  builder->AddChannelArgument(GRPC_ARG_HTTP2_BDP_PROBE, 0);
  grpc::ResourceQuota quota("fovea");
  quota.Resize(GrpcQuotaOf(options));
  quota.SetMaxThreads(kMaxThreads);
  builder->SetResourceQuota(quota);
  // Clients may ping an idle connection this often without being cut off.
  builder->AddChannelArgument(GRPC_ARG_HTTP2_MIN_RECV_PING_INTERVAL_WITHOUT_DATA_MS, 10'000);
  // A machine that went without a word is noticed, and half a handshake does not last.
  builder->AddChannelArgument(GRPC_ARG_KEEPALIVE_TIME_MS, 30'000);
  builder->AddChannelArgument(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, 10'000);
  builder->AddChannelArgument(GRPC_ARG_SERVER_HANDSHAKE_TIMEOUT_MS, 5'000);
  builder->AddChannelArgument(GRPC_ARG_MAX_CONNECTION_IDLE_MS, options.max_idle_s * 1000);
  if (const int age_s = options.max_connection_age_s; age_s > 0) {
    builder->AddChannelArgument(GRPC_ARG_MAX_CONNECTION_AGE_MS, age_s * 1000);
    // A stream that is opened last thing ends itself before: see StreamCall.
    builder->AddChannelArgument(GRPC_ARG_MAX_CONNECTION_AGE_GRACE_MS, (2 * age_s + 60) * 1000);
  }
  builder->AddChannelArgument(GRPC_ARG_MAX_CONCURRENT_STREAMS, kMaxCallsPerConnection);
}

}  // namespace

Server::Server(const ServerOptions& options, DetectFunction detect)
    : options_(Validated(options)),
      limits_(SchedulerLimitsOf(options_)),
      scheduler_(limits_),
      metrics_(std::make_shared<Metrics>()),
      tracer_(MakeTracer(options_)),
      observer_gate_(options_.observers),
      watch_hub_(MakeWatchHub(options_)),
      trial_bench_(MakeIfWatched<TrialBench>(options_)),
      pick_board_(MakeIfWatched<PickBoard>(options_)),
      answerer_(std::move(detect), options_, *metrics_, tracer_.get(), watch_hub_.get()),
      credentials_(options_),
      gate_keeper_(options_.tokens, credentials_.authority()),
      stream_places_(StreamLimitsOf(options_)),
      unsent_answers_(static_cast<std::size_t>(options_.max_unsent_mib) << 20),
      frame_room_(static_cast<std::size_t>(options_.max_receiving_mib) << 20),
      connections_(ConnectionLimitsOf(options_)),
      service_(InfoOf(options_, limits_),
               OptionList({options_.client_options, options_.fixed_options}), *metrics_,
               gate_keeper_, connections_),
      door_(options_.listen, connections_) {
  AddGauges();
  if (tracer_) AddTraceCounters();
  if (watch_hub_) AddWatchCounters();
  EnablePlugins();
  try {
    Listen();
    Serve();
  } catch (...) {  // what has begun ends in the order of Stop(), or never
    Stop(/*timeout_s=*/0);
    throw;
  }
}

void Server::AddGauges() {
  metrics_->AddGauge("fovea_frames_waiting", "Frames that wait for a compute thread",
                     [this] { return static_cast<double>(scheduler_.NumWaiting()); });
  metrics_->AddGauge("fovea_busy_threads", "Compute threads that work on a frame",
                     [this] { return static_cast<double>(scheduler_.NumBusy()); });
  metrics_->AddGauge("fovea_connections", "Connections that are open",
                     [this] { return static_cast<double>(connections_.counts().open); });
  metrics_->AddGauge("fovea_receiving_bytes", "What has come of messages that are not whole yet",
                     [this] { return static_cast<double>(connections_.counts().receiving_bytes); });
  metrics_->AddCounter("fovea_connections_accepted_total", "Connections that came in",
                       [this] { return static_cast<double>(connections_.counts().accepted); });
  metrics_->AddCounter("fovea_connections_refused_total", "Connections that found no place",
                       [this] { return static_cast<double>(connections_.counts().refused); });
  metrics_->AddCounter("fovea_connections_ended_total",
                       "Connections that held more, or longer, than they may, or made room",
                       [this] { return static_cast<double>(connections_.counts().ended); });
  const auto seconds = [](auto t) { return static_cast<double>(t->time_since_epoch().count()); };
  if (credentials_.has_tls()) {
    metrics_->AddGauge("fovea_certificate_expiry_timestamp_seconds",
                       "When the server's certificate expires, in seconds since 1970",
                       [=, this] { return seconds(credentials_.Expiry()); });
  }
  if (credentials_.authority()) {
    metrics_->AddGauge("fovea_client_authority_expiry_timestamp_seconds",
                       "When the first of the authorities of clients does",
                       [=, this] { return seconds(credentials_.AuthorityExpiry()); });
  }
  metrics_->AddGauge("fovea_compute_threads", "Frames that can be computed at once",
                     [this] { return static_cast<double>(limits_.num_threads); });
}

void Server::AddTraceCounters() {
  metrics_->AddCounter("fovea_traces_sent_total", "Frames whose spans the collector took",
                       [this] { return static_cast<double>(tracer_->exporter().num_sent()); });
  metrics_->AddCounter(
      "fovea_traces_dropped_total",
      "Frames whose spans were dropped: the collector is away, too slow or refuses them",
      [this] { return static_cast<double>(tracer_->exporter().num_dropped()); });
}

void Server::AddWatchCounters() {
  metrics_->AddGauge("fovea_watchers", "Calls that watch",
                     [this] { return static_cast<double>(watch_hub_->counts().watchers); });
  metrics_->AddGauge("fovea_watch_waiting_bytes", "What waits to be shown or sent to them",
                     [this] { return static_cast<double>(watch_hub_->counts().waiting_bytes); });
  metrics_->AddCounter("fovea_frames_tried_total", "Frames that observers tried options on",
                       [this] { return static_cast<double>(trial_bench_->num_done()); });
  metrics_->AddCounter("fovea_watched_frames_total", "Frames shown, to each of them",
                       [this] { return static_cast<double>(watch_hub_->counts().shown); });
  metrics_->AddCounter("fovea_watched_frames_dropped_total",
                       "Frames not shown: a newer one came, or there was no room",
                       [this] { return static_cast<double>(watch_hub_->counts().dropped); });
}

void Server::Listen() {
  grpc::ServerBuilder builder;
  ConfigureChannel(options_, &builder);
  using Type = grpc::ServerBuilder::experimental_type::ExternalConnectionType;
  auto callers =
      builder.experimental().AddExternalConnectionAcceptor(Type::FROM_FD, credentials_.ForGrpc());
  auto self = builder.experimental().AddExternalConnectionAcceptor(
      Type::FROM_FD, grpc::InsecureServerCredentials());
  builder.RegisterService(&service_);
  if (watch_hub_) builder.RegisterService(&observation_service_);
  std::vector<std::unique_ptr<grpc::experimental::ServerInterceptorFactoryInterface>> limits;
  limits.push_back(MakeReflectionLimit());
  builder.experimental().SetInterceptorCreators(std::move(limits));
  // In any case: a queue that nobody empties cannot be given back.
  loop_ = std::make_unique<EventLoop>(builder.AddCompletionQueue());
  server_ = builder.BuildAndStart();
  if (!server_) throw std::runtime_error("gRPC cannot start; the log says more");
  callers_ = std::move(callers);
  self_ = std::move(self);
}

void Server::Serve() {
  environment_ = std::make_unique<CallEnvironment>(
      CallEnvironment{service_, loop_->queue(), scheduler_, answerer_, live_calls_, *metrics_,
                      gate_keeper_, stream_places_, connections_, pick_board_.get(),
                      std::chrono::seconds(options_.max_transfer_s), unsent_answers_, frame_room_,
                      std::chrono::seconds(options_.max_connection_age_s)});
  service_.Use({environment_->queue, environment_->max_transfer, environment_->unsent});
  DetectCall::Accept(*environment_);
  StreamCall::Accept(*environment_);
  if (watch_hub_) AcceptObservers();
  server_->GetHealthCheckService()->SetServingStatus(v1::DetectionService::service_full_name(),
                                                     true);
  door_.Open(std::move(callers_), std::move(self_));
  serving_ = true;
  access_watch_ =
      std::make_unique<AccessWatch>(std::chrono::seconds(options_.tls_reload_s), credentials_,
                                    gate_keeper_, observer_gate_, [this] { live_calls_.Check(); });
}

void Server::AcceptObservers() {
  observation_environment_ = std::make_unique<ObservationEnvironment>(ObservationEnvironment{
      observation_service_, loop_->queue(), live_calls_, observer_gate_, *watch_hub_, answerer_,
      *trial_bench_, *pick_board_, service_.options(), connections_,
      std::chrono::seconds(options_.max_transfer_s), unsent_answers_});
  observation_service_.Use(*observation_environment_);
  WatchCall::Accept(*observation_environment_);
}

void Server::ReloadAccess() {
  // All are read before one is taken over.
  credentials_.Reload(gate_keeper_, [this] {
    observer_gate_.RequireUsable();
    gate_keeper_.Reload();
    observer_gate_.Reload();
  });
  gate_keeper_.LogTokens(/*also_good=*/true);
  observer_gate_.LogTokens(/*also_good=*/true);
  live_calls_.Check();
}

Server::~Server() { Stop(/*timeout_s=*/0); }

std::vector<std::string> Server::Addresses() const {
  std::vector<std::string> addresses;
  for (const ListeningSocket& listening : door_.listening()) {
    addresses.push_back(listening.address());
  }
  return addresses;
}

void Server::StopAdvertising() {
  serving_ = false;
  server_->GetHealthCheckService()->SetServingStatus(false);
}

std::size_t Server::Stop(int timeout_s) {
  if (!server_) return 0;
  const std::chrono::seconds patience(timeout_s);
  StopAdvertising();
  access_watch_.reset();
  door_.Close();
  live_calls_.Stop();
  // Begun at once, since it has callers turn elsewhere with what they ask next (GOAWAY); last thing
  // where there are no threads to be had. Its own end is later than ours, which says who it was.
  const auto shutdown = std::async(std::launch::async | std::launch::deferred,
                                   [&, end = std::chrono::system_clock::now() + patience +
                                             2 * kLastWords] { server_->Shutdown(end); });
  live_calls_.WaitUntilIdle(std::chrono::steady_clock::now() + patience);
  // What is left then is late, has just been refused, or only watches the health.
  const bool late = shutdown.wait_for(kLastWords) == std::future_status::timeout;
  const std::size_t num_cancelled = late ? live_calls_.GiveUp() : 0;
  if (late) grpc_server_cancel_all_calls(server_->c_server());
  shutdown.wait();
  server_->Wait();
  live_calls_.WaitUntilNone();
  loop_.reset();
  server_.reset();
  return num_cancelled;
}

}  // namespace fovea::server
