#include "server/server.h"

#include <grpcpp/ext/proto_server_reflection_plugin.h>
#include <grpcpp/grpcpp.h>
#include <grpcpp/health_check_service_interface.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <utility>

namespace fovea::server {
namespace {

const ServerOptions& Validated(const ServerOptions& options) {
  Validate(options);
  return options;
}

int NumSlots(const ServerOptions& options) {
  if (options.max_concurrent > 0) return options.max_concurrent;
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

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
  // Else a second server on the same port would start and take half of the calls.
  builder->AddChannelArgument(GRPC_ARG_ALLOW_REUSEPORT, 0);
  // Clients may ping an idle connection this often without being cut off.
  builder->AddChannelArgument(GRPC_ARG_HTTP2_MIN_RECV_PING_INTERVAL_WITHOUT_DATA_MS, 10'000);
}

}  // namespace

Server::Server(const ServerOptions& options, DetectFunction detect)
    : options_(Validated(options)),
      service_(std::move(detect), options_.max_pixels, NumSlots(options_)) {
  EnablePlugins();
  grpc::ServerBuilder builder;
  ConfigureChannel(options_, &builder);
  builder.AddListeningPort(options_.listen, grpc::InsecureServerCredentials(), &port_);
  builder.RegisterService(&service_);
  server_ = builder.BuildAndStart();
  if (!server_ || port_ == 0) {
    throw std::runtime_error("--listen: cannot listen on " + options_.listen +
                             ": the port is in use or the address is not one of this machine");
  }
  server_->GetHealthCheckService()->SetServingStatus(v1::DetectionService::service_full_name(),
                                                     true);
}

Server::~Server() { Stop(/*timeout_s=*/0); }

std::string Server::Address() const {
  return HostOf(options_.listen) + ":" + std::to_string(port_);
}

void Server::Drain() { Stop(options_.drain_timeout_s); }

void Server::Stop(int timeout_s) {
  if (!server_) return;
  server_->GetHealthCheckService()->SetServingStatus(false);
  service_.EndStreams();
  server_->Shutdown(std::chrono::system_clock::now() + std::chrono::seconds(timeout_s));
  server_->Wait();
  server_.reset();
}

}  // namespace fovea::server
