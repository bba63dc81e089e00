#include "client/client.h"

#include <algorithm>
#include <stdexcept>
#include <thread>
#include <utility>

#include "client/channel.h"
#include "client/retry.h"
#include "client/servers.h"
#include "grpc/health/v1/health.grpc.pb.h"

namespace fovea::client {
namespace {

namespace health = grpc::health::v1;

health::HealthCheckRequest AboutDetection() {
  health::HealthCheckRequest request;
  request.set_service(v1::DetectionService::service_full_name());
  return request;
}

struct Health {
  grpc::Status status;
  bool serving = false;
};

Health HealthOf(const Server& server, const ClientOptions& options,
                Servers::Clock::duration timeout) {
  grpc::ClientContext context;
  PrepareCall(options, std::chrono::duration_cast<std::chrono::milliseconds>(timeout), &context);
  health::HealthCheckResponse response;
  Health health;
  health.status =
      health::Health::NewStub(server.channel)->Check(&context, AboutDetection(), &response);
  health.serving = health.status.ok() && response.status() == health::HealthCheckResponse::SERVING;
  return health;
}

// Which may still come.
bool IsAbsence(const grpc::Status& status) {
  return status.ok() || status.error_code() == grpc::StatusCode::UNAVAILABLE ||
         status.error_code() == grpc::StatusCode::CANCELLED ||
         status.error_code() == grpc::StatusCode::DEADLINE_EXCEEDED;
}

grpc::Status NotReady(grpc::StatusCode code, const std::string& problem) {
  return {code, "the server is not ready: " + problem};
}

// Ends further away, as that of milliseconds::max(), overflow the clocks and would be past.
std::chrono::milliseconds Capped(std::chrono::milliseconds timeout) {
  constexpr std::chrono::milliseconds kLongest = std::chrono::seconds(1'000'000'000);
  return std::clamp(timeout, -kLongest, kLongest);
}

// gRPC takes any text and fails at each call, without a word about it.
void RequirePem(const std::string& name, const std::string& text, const std::string& kind) {
  if (text.empty() || text.find(kind + "-----") != std::string::npos) return;
  throw std::invalid_argument("tls." + name + ": holds no " + kind +
                              " in PEM; it takes the text of a file, not its path");
}

void RequireTls(const TlsOptions& tls) {
  // gRPC ends the program where one of them is missing.
  if (tls.certificate_chain.empty() != tls.private_key.empty()) {
    throw std::invalid_argument("tls: certificate_chain and private_key go together");
  }
  RequirePem("root_certificates", tls.root_certificates, "CERTIFICATE");
  RequirePem("certificate_chain", tls.certificate_chain, "CERTIFICATE");
  RequirePem("private_key", tls.private_key, "PRIVATE KEY");
}

void RequirePrintable(const std::string& name, const std::string& text) {
  if (IsPrintableAscii(text)) return;
  throw std::invalid_argument(name + ": \"" + text + "\" is not printable ASCII");
}

// What the server would refuse has no place in its log, and errors would say that it has.
void Check(const CallOptions& call) {
  constexpr std::size_t kLongestId = 64;
  RequirePrintable("request_id", call.request_id);
  if (call.request_id.size() > kLongestId) {
    throw std::invalid_argument("request_id: has " + std::to_string(call.request_id.size()) +
                                " characters, more than " + std::to_string(kLongestId));
  }
  RequirePrintable("traceparent", call.traceparent);
}

ClientOptions Checked(ClientOptions options) {
  RequirePrintable("robot", options.robot);
  if (!IsPrintableAscii(options.token)) {
    throw std::invalid_argument("token: is not printable ASCII");
  }
  constexpr int kMaxMib = 2047;  // gRPC counts the bytes in an int
  if (options.max_answer_mib < 1 || options.max_answer_mib > kMaxMib) {
    throw std::invalid_argument("max_answer_mib: " + std::to_string(options.max_answer_mib) +
                                " is not 1 to " + std::to_string(kMaxMib));
  }
  if (options.tls) RequireTls(*options.tls);
  options.timeout = Capped(options.timeout);
  return options;
}

}  // namespace

bool IsPrintableAscii(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

Client::Client(const std::string& address, ClientOptions options)
    : options_(Checked(std::move(options))),
      servers_(std::make_shared<Servers>(address, options_)) {}

void Client::WaitUntilReady(std::chrono::milliseconds timeout) const {
  using Clock = Servers::Clock;
  constexpr std::chrono::milliseconds kBetween{50}, kLongestLook{1000};
  const Clock::time_point deadline = Clock::now() + Capped(timeout);
  std::string problem;
  while (Clock::now() < deadline) {
    const auto servers = servers_->All(deadline, &problem);
    for (const auto& server : servers) {
      const auto look = std::min<Clock::duration>(deadline - Clock::now(), kLongestLook);
      const Health health = HealthOf(*server, options_, look);
      if (health.serving) return;
      problem = health.status.ok() ? "it does not serve" : health.status.error_message();
      if (!IsAbsence(health.status)) throw RpcError(NotReady(health.status.error_code(), problem));
    }
    const auto rest = std::min<Clock::duration>(deadline - Clock::now(), kBetween);
    const auto pause = std::chrono::duration_cast<std::chrono::milliseconds>(rest);
    if (servers.empty()) {
      std::this_thread::sleep_for(pause);
    } else {
      Pause(*servers.front()->channel, pause);
    }
  }
  throw RpcError(NotReady(grpc::StatusCode::DEADLINE_EXCEEDED, problem));
}

bool Client::IsServing() const {
  const auto deadline = Servers::Clock::now() + options_.timeout;
  std::string problem;
  grpc::Status status(grpc::StatusCode::UNAVAILABLE, "");
  bool answered = false;
  for (const auto& server : servers_->All(deadline, &problem)) {
    const Health health = HealthOf(*server, options_, deadline - Servers::Clock::now());
    if (health.serving) return true;
    answered |= health.status.ok();
    status = health.status;
  }
  if (answered) return false;
  throw RpcError(problem.empty() ? status : grpc::Status(status.error_code(), problem));
}

v1::GetServerInfoResponse Client::GetServerInfo() const {
  v1::GetServerInfoResponse response;
  CallWithRetries(*servers_, options_, options_.timeout, [&](auto& stub, auto* context) {
    return stub.GetServerInfo(context, {}, &response);
  });
  return response;
}

v1::GetStatisticsResponse Client::GetStatistics() const {
  v1::GetStatisticsResponse response;
  CallWithRetries(*servers_, options_, options_.timeout, [&](auto& stub, auto* context) {
    return stub.GetStatistics(context, {}, &response);
  });
  return response;
}

v1::ListOptionsResponse Client::ListOptions() const {
  v1::ListOptionsResponse response;
  CallWithRetries(*servers_, options_, options_.timeout, [&](auto& stub, auto* context) {
    return stub.ListOptions(context, {}, &response);
  });
  return response;
}

v1::DetectResponse Client::Detect(const v1::DetectRequest& request, const CallOptions& call) const {
  return Detect(request, options_.timeout, call);
}

v1::DetectResponse Client::Detect(const v1::DetectRequest& request,
                                  std::chrono::milliseconds timeout,
                                  const CallOptions& call) const {
  Check(call);
  v1::DetectResponse response;
  const auto detect = [&](auto& stub, auto* context) {
    return stub.Detect(context, request, &response);
  };
  CallWithRetries(*servers_, options_, Capped(timeout), detect, call);
  return response;
}

std::unique_ptr<DetectStream> Client::OpenStream(std::chrono::milliseconds timeout,
                                                 const CallOptions& call) const {
  Check(call);
  std::string problem;
  timeout = Capped(timeout);
  const auto home = servers_->Home(Servers::Clock::now() + timeout, &problem);
  if (!home) {
    throw RpcError({grpc::StatusCode::UNAVAILABLE, problem}, std::nullopt, call.request_id);
  }
  return std::make_unique<DetectStream>(*home->channel, options_, timeout, call);
}

std::unique_ptr<ResumingStream> Client::OpenResumingStream(std::chrono::milliseconds timeout,
                                                           const CallOptions& call) const {
  Check(call);
  return std::make_unique<ResumingStream>(servers_, options_, Capped(timeout), call);
}

}  // namespace fovea::client
