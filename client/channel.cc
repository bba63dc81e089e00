#include "client/channel.h"

#include <grpcpp/create_channel.h>
#include <grpcpp/security/credentials.h>

namespace fovea::client {
namespace {

std::shared_ptr<grpc::ChannelCredentials> CredentialsOf(const std::optional<TlsOptions>& tls) {
  if (!tls) return grpc::InsecureChannelCredentials();
  return grpc::SslCredentials({.pem_root_certs = tls->root_certificates,
                               .pem_private_key = tls->private_key,
                               .pem_cert_chain = tls->certificate_chain});
}

}  // namespace

std::shared_ptr<grpc::Channel> MakeChannel(const ServerTarget& target, bool has_others,
                                           const ClientOptions& options) {
  grpc::ChannelArguments arguments;
  arguments.SetMaxReceiveMessageSize(options.max_answer_mib << 20);
  if (!target.authority.empty()) {
    arguments.SetString(GRPC_ARG_DEFAULT_AUTHORITY, target.authority);
  }
  // Else gRPC puts all clients of a process on one connection, where a small call waits for the
  // large frames of the others.
  arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
  // Else http_proxy takes frames, those for this machine too, to a proxy for web pages.
  arguments.SetInt(GRPC_ARG_ENABLE_HTTP_PROXY, 0);
  // A server that is back is found soon, one that is gone without a word is noticed.
  arguments.SetInt(GRPC_ARG_INITIAL_RECONNECT_BACKOFF_MS, 100);
  // Also the time that one attempt has, TLS included.
  arguments.SetInt(GRPC_ARG_MIN_RECONNECT_BACKOFF_MS, has_others ? 2'000 : 5'000);
  arguments.SetInt(GRPC_ARG_MAX_RECONNECT_BACKOFF_MS, 1'000);
  arguments.SetInt(GRPC_ARG_DNS_MIN_TIME_BETWEEN_RESOLUTIONS_MS, 5'000);  // of 30'000
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIME_MS, 20'000);
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, 5'000);
  return grpc::CreateCustomChannel(target.target, CredentialsOf(options.tls), arguments);
}

void Pause(grpc::Channel& channel, std::chrono::milliseconds wait) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end = Clock::now() + wait;
  for (auto now = Clock::now(); now < end; now = Clock::now()) {
    channel.WaitForStateChange(channel.GetState(true),
                               std::chrono::system_clock::now() + (end - now));
  }
}

void PrepareCall(const ClientOptions& options, std::chrono::milliseconds timeout,
                 grpc::ClientContext* context, const CallOptions& call) {
  context->set_deadline(std::chrono::system_clock::now() + timeout);
  if (!options.token.empty()) context->AddMetadata("authorization", "Bearer " + options.token);
  if (!options.robot.empty()) context->AddMetadata("fovea-robot", options.robot);
  if (!call.request_id.empty()) context->AddMetadata("fovea-request-id", call.request_id);
  if (!call.traceparent.empty()) context->AddMetadata("traceparent", call.traceparent);
}

}  // namespace fovea::client
